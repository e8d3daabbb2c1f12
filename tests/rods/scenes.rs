//! Rods.

newton_euler::rigid_body!(Pulled {
    motion: rod(body(1, 0, 0)),
    inputs: [pull = world(_, _, _)[N]],
    mass: 1.2[kg],
    inertia: 0.064[kg * m ^ 2],
    points: [end = (1, 0, 0)],
    forces: [pulled = pull.at(end)],
});

newton_euler::rigid_body!(Twisted {
    motion: rod(body(0, 0, -1)),
    inputs: [k = world(_, _, _)[N * m]],
    mass: 1.2[kg],
    inertia: 0.064[kg * m ^ 2],
    moments: [across = axis.cross(k).cross(axis)],
});

newton_euler::rigid_body!(Free {
    motion: rod(body(0, 1, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
});

/// The same rod, with numbers and with parameters, in a direction that is no axis of the body.
macro_rules! pole {
    ($name:ident, $params:tt, $m:tt, $j:tt, $s:tt, $drag:tt, $stiffness:tt) => {
        newton_euler::rigid_body!($name {
            motion: rod(body(3, 0, 4)),
            params: $params,
            inputs: [
                push = world(_, _, _)[N],
                wind = world(_, _, _)[m / s],
                k = world(_, _, _)[N * m],
                thrust[N]
            ],
            mass: $m,
            inertia: $j,
            points: [
                tip = (0.6 * $s, 0, 0.8 * $s),
                tail = (-0.3, 0, -0.4)[m],
                hook = world(1.5, 2, -1),
                mast = world(-1, 0.5, 2),
                wall = world(-1, 0.5, 0.25),
            ],
            pole: wall,
            locals: [air = tail.velocity() - wind],
            joint_forces: [linked = (2 * push).at(tail)],
            joint_moments: [bent = axis.cross(k)],
            forces: [
                pushed = push.at(tip),
                drag = (-$drag * air.norm() * air).at(tail),
                spring = ($stiffness * (mast.position() - tip.position())).at(tip),
                driven = body(0.6 * thrust, 0, 0.8 * thrust).at(tip),
                carried = (0.5 * angular_velocity.cross(push)).at(tip),
                beside = (1[N] * axis).at(tip + 0.25[m] * axis),
            ],
            moments: [
                damped = -0.3 * angular_velocity,
                slowed = -0.2 * axis.cross(axis_rate)
            ],
            fields: [
                weight = mass * world(0, 0, -9.80665),
                lifted = world(0.5, 2, -1).at(tip),
                electric = world(3, -2, 4)[V / m].on([1[C].at(tip), -0.5[C].at(tail)]),
            ],
            potentials: [
                stretched =
                    10[N / m] * ((tip.position() - hook.position()).norm() - 0.5[m]).powi(2),
                leaning = 4[N * m] * axis.dot(world(0.6, 0, 0.8)).powi(2),
            ],
            outputs: [energy, momentum, balance],
        });
    };
}

pole!(Baked, [], 2.5, 0.3, 0.4, 0.8, 12.5);
pole!(
    Parametric,
    [m = 2.5, j = 0.3, s = 0.4, c = 0.8, k_s = 12.5],
    m,
    j,
    s,
    c,
    k_s
);

newton_euler::rigid_body!(Swinging {
    motion: rod(body(1, 0, 0)),
    mass: 1.2[kg],
    inertia: rod(0.8[m]),
    points: [end = (0.3, 0, 0), hook = world(0.2, 0.1, 1)],
    fields: [weight = mass * world(0, 0, -9.80665)],
    potentials: [
        spring = 20[N / m] * ((end.position() - hook.position()).norm() - 0.4[m]).powi(2) / 2,
    ],
    outputs: [energy],
});

newton_euler::rigid_body!(Floating {
    motion: rod(body(1, 0, 0)),
    mass: 1.2[kg],
    inertia: rod(0.8[m]),
    pole: world(1, 2, 3),
    outputs: [energy, momentum],
});

/// One description of a thin body, as a rod and as a cylinder.
macro_rules! dart {
    ($name:ident, $motion:expr, $inertia:expr) => {
        newton_euler::rigid_body!($name {
            motion: $motion,
            mass: 0.5[kg],
            inertia: $inertia,
            points: [
                tip = (0, 0, 0.6),
                tail = (0, 0, -0.6),
                hook = world(0.4, -0.3, 1)
            ],
            locals: [air = tail.velocity() - world(1, 0.5, 0)[m / s]],
            fields: [weight = mass * world(0, 0, -9.80665)],
            forces: [
                drag = (-0.2[N * s / m] * air).at(tail),
                thrust = body(0, 0, 3)[N].at(tip),
            ],
            moments: [damped = -0.05[N * m * s] * angular_velocity],
            potentials: [spring = 6[N / m] * (tip.position() - hook.position()).norm_squared()],
        });
    };
}

dart!(Thin, spatial, cylinder(2e-5[m], 1.2[m]));
dart!(Slender, rod(body(0, 0, 1)), rod(1.2[m]));

newton_euler::rigid_body!(Hung {
    motion: rod(body(1, 0, 0)),
    mass: 1.2[kg],
    inertia: rod(0.8[m]),
    points: [end = (-0.4, 0, 0)],
    fields: [weight = mass * world(0, 0, -9.80665)],
    reactions: [pin = world(_, _, _).at(end)],
    constraints: [held = end.position()],
    outputs: [energy, reactions, balance],
});

newton_euler::rigid_body!(Ladder {
    motion: rod(body(0, 1, 0)),
    mass: 9[kg],
    inertia: rod(4[m]),
    points: [foot = (0, -2, 0), _top = (0, 2, 0)],
    fields: [weight = mass * world(0, 0, -9.80665)],
    reactions: [
        floor = world(0, 0, _).at(foot),
        wall = (_ * world(1, 0, 0)).at(_top)
    ],
    constraints: [
        on_floor = foot.position().in_world().z,
        at_wall = _top.velocity().in_world().x,
    ],
    outputs: [energy, reactions],
});

/// J of the same rod, said in different ways.
macro_rules! inertias {
    ($($name:ident: $axis:expr, $end:expr, $inertia:expr;)*) => {
        $(newton_euler::rigid_body!($name {
            motion: rod($axis),
            params: [_l = 0.5[m], j = 0.064[kg * m ^ 2]],
            mass: 2[kg],
            inertia: $inertia,
            points: [_end = $end],
            moments: [_unused = axis.cross(world(0, 0, j / 1[s ^ 2]))],
            outputs: [momentum],
        });)*
    };
}

inertias! {
    Number: body(1, 0, 0), (0.5, 0, 0), 0.064[kg * m ^ 2];
    Param: body(1, 0, 0), (0.5, 0, 0), j;
    AboutEnd: body(1, 0, 0), (0.5, 0, 0), 0.564[kg * m ^ 2].about(_end);
    Principal: body(0, 1, 0), (0, 0.5, 0), principal(0.064, 0, 0.064)[kg * m ^ 2];
    Open: body(0, 0, 1), (0, 0, 0.5), principal(j, j, 0);
    Tensor: body(3, 0, 4), (0.3, 0, 0.4), tensor { xx: 0.04096, yy: 0.064, zz: 0.02304, zx: -0.03072 }[kg * m ^ 2];
    TensorAboutEnd: body(0, 0, 1), (0, 0, 0.5), tensor { xx: 0.564, yy: 0.564, zz: 0 }[kg * m ^ 2].about(_end);
    Solid: body(1, 2, 2), (1, 2, 2), rod(0.384[m ^ 2].sqrt());
}

newton_euler::rigid_body!(Dumbbell {
    motion: rod(body(1, 0, 0)),
    params: [l = 0.5[m]],
    inertia: compose([
        rod(l).mass(0.3[kg]).at((l, 0.5, 0)),
        point(0.5[kg]).at((1.5 * l, 0.5, 0)),
        0.001[kg * m ^ 2].mass(0.2[kg]).at((0.5 * l, 0.5, 0)),
    ]),
    points: [end = (2 * l, 0.5, 0)],
    outputs: [momentum],
    locals: [_place = end.position()],
});

/// `axis` is a name like any other where there is no rod.
mod other_motions {
    newton_euler::rigid_body!(Lever {
        motion: planar,
        params: [axis = 0.5[m], axis_rate = 2],
        mass: 1[kg],
        inertia: axis_rate * 0.1[kg * m ^ 2],
        points: [end = (axis, 0)],
        forces: [push = body(0, 1).at(end)],
    });
}
pub use other_motions::*;

newton_euler::rigid_body!(Branched {
    motion: rod(body(1, 0, 0)),
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [tip = (0.5, 0, 0)],
    forces: [
        late = (if t > 3[s] {
            world(0, 1, 2)[N]
        } else {
            2[N] * axis
        })
        .at(tip),
        fast = (1[kg / s] * (velocity.norm() - 5[m / s]).max(0) * world(1, 0, 3)).at(tip),
    ],
    moments: [damped = if t > 3[s] {
        -0.2[N * m * s] * angular_velocity
    } else {
        1[N * m] * axis.cross(world(0, 2, 0))
    },],
});

newton_euler::rigid_body!(Level {
    motion: rod(body(1, 0, 0)),
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [tip = (0.5, 0, 0)],
    forces: [push = world(1, 2, 3)[N].at(tip)],
    reactions: [guide = moment(_ * axis.cross(world(0, 0, 1)))],
    constraints: [level = axis.dot(world(0, 0, 1))],
    outputs: [reactions, balance],
});

newton_euler::rigid_body!(Named {
    motion: rod(along),
    params: [slope = 0.75, m = 2[kg]],
    locals: [along = body(1, slope, 0), twice = 2[N] * along],
    mass: m,
    inertia: 0.1[kg * m ^ 2],
    forces: [first = twice, second = (4[N] * along).at((1, slope, 0))],
});
