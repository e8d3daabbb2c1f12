//! Bodies with every kind of motion, under loads of every kind.

/// In space.
macro_rules! block {
    ($name:ident, [$($motion:tt)*], $($inertia:tt)*) => {
        newton_euler::rigid_body!($name {
            motion: $($motion)*,
            params: [m = 1.9[kg]],
            inputs: [push = body(_, _, _)[N], wind = world(_, _, _)[m / s]],
            mass: m,
            $($inertia)*
            points: [hook = (0.3, 0.25, -0.2), tip = (-0.3, 0.2, 0.4), wall = world(1.5, 2, -1)],
            locals: [air = tip.velocity() - wind],
            fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
            forces: [
                pushed = push.at(tip),
                drag = (-0.2 * air.norm() * air).at(tip),
                spring = (30 * (wall.position() - hook.position())).at(hook),
                shaken = world(0, 2 * (3 * t / 1[s]).sin(), 0).at(hook),
            ],
            outputs: [taylor],
        });
    };
}

block!(Spatial, [spatial], inertia: tensor { xx: 0.3206, yy: 0.239, zz: 0.37, xy: 0.0276, yz: 0.0602, zx: 0.0316 }[kg * m ^ 2],);
block!(FixedPoint, [fixed_point(hook)], inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],);
block!(FixedAxis, [fixed_axis(hook, world(1, 2, 2))], inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],);

newton_euler::rigid_body!(Translation {
    motion: translation,
    inputs: [push = world(_, _, _)[N], wind = world(_, _, _)[m / s]],
    mass: 1.9[kg],
    points: [wall = world(1.5, 2, -1)],
    locals: [air = velocity - wind],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    forces: [
        pushed = push,
        drag = -0.2 * air.norm() * air,
        spring = 30 * (wall.position() - position),
    ],
    outputs: [taylor],
});

newton_euler::rigid_body!(Rotation {
    motion: rotation,
    inputs: [push = body(_, _, _)[N * m], wind = world(_, _, _)[N * m]],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    moments: [
        pushed = push,
        blown = wind,
        damped = -0.1[N * m * s] * angular_velocity
    ],
    outputs: [taylor],
});

newton_euler::rigid_body!(Rod {
    motion: rod(body(1, 0, 0)),
    inputs: [push = world(_, _, _)[N], wind = world(_, _, _)[m / s]],
    mass: 1.9[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [
        tip = (0.4, 0, 0),
        hook = (-0.3, 0, 0),
        wall = world(1.5, 2, -1)
    ],
    locals: [air = tip.velocity() - wind],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    forces: [
        pushed = push.at(tip),
        drag = (-0.2 * air.norm() * air).at(tip),
        spring = (30 * (wall.position() - hook.position())).at(hook),
    ],
    outputs: [taylor],
});

/// In the plane.
macro_rules! plate {
    ($name:ident, [$($motion:tt)*]) => {
        newton_euler::rigid_body!($name {
            motion: $($motion)*,
            inputs: [push = body(_, _)[N], wind = world(_, _)[m / s]],
            mass: 1.9[kg],
            inertia: 0.37[kg * m ^ 2],
            points: [hook = (0.3, 0.25), tip = (-0.3, 0.2), wall = world(1.5, 2)],
            locals: [air = tip.velocity() - wind],
            fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
            forces: [
                pushed = push.at(tip),
                drag = (-0.2 * air.norm() * air).at(tip),
                spring = (30 * (wall.position() - hook.position())).at(hook),
            ],
            outputs: [taylor],
        });
    };
}

plate!(Planar, [planar]);
plate!(Pivot, [pivot(hook)]);

newton_euler::rigid_body!(PlanarTranslation {
    motion: planar_translation,
    inputs: [push = world(_, _)[N], wind = world(_, _)[m / s]],
    mass: 1.9[kg],
    points: [wall = world(1.5, 2)],
    locals: [air = velocity - wind],
    forces: [
        pushed = push,
        drag = -0.2 * air.norm() * air,
        spring = 30 * (wall.position() - position)
    ],
    outputs: [taylor],
});

newton_euler::rigid_body!(Stone {
    motion: translation,
    mass: 3[kg],
    fields: [weight = mass * world(0, 0, -10[m / s ^ 2])],
    outputs: [taylor],
});

newton_euler::rigid_body!(SymmetricFree {
    motion: rotation,
    inertia: principal(2, 2, 1)[kg * m ^ 2],
    outputs: [taylor, energy, momentum],
});

newton_euler::rigid_body!(AsymmetricFree {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [taylor, energy, momentum],
});

newton_euler::rigid_body!(Brick {
    motion: rotation,
    inertia: principal(10, 20, 26)[kg * m ^ 2],
    outputs: [taylor],
});

/// The torque k Γ × c is the moment of a weight k at the arm c.
macro_rules! top {
    ($name:ident, $inertia:expr, $weight:literal, $arm:literal) => {
        newton_euler::rigid_body!($name {
            motion: rotation,
            inertia: $inertia,
            moments: [weight = body(0, 0, $arm[m]).cross(world(0, 0, -$weight[N]))],
            outputs: [taylor],
        });
    };
}

top!(LagrangeTop, principal(1, 1, 0.5)[kg * m ^ 2], 5, 1);
top!(HeavyAsym, principal(0.6, 0.8, 1)[kg * m ^ 2], 1, 1);
top!(Hanging, principal(0.3, 0.5, 0.4)[kg * m ^ 2], 4, -1);

newton_euler::rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [taylor, energy],
});

newton_euler::rigid_body!(AnyPendulum::<T> {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

newton_euler::rigid_body!(Falling {
    motion: translation,
    mass: 1[kg],
    forces: [drawn = -1[N * m ^ 2] * position / position.norm().powi(3)],
    outputs: [taylor],
});

newton_euler::rigid_body!(Driven {
    motion: planar_translation,
    inputs: [push[N]],
    mass: 2[kg],
    forces: [shaken = world(3 * (2 * t / 1[s]).sin(), push)],
    outputs: [taylor],
});
