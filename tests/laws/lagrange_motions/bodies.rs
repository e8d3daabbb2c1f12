//! The same body in every kind of motion.

/// In space: the kind of motion, its reactions, its outputs.
macro_rules! block {
    ($name:ident, [$($motion:tt)*], $reactions:tt, $outputs:tt) => {
        newton_euler::rigid_body!($name {
            motion: $($motion)*,
            inputs: [push = body(_, _, _)[N], twist = body(_, _, _)[N * m]],
            mass: 1.9[kg],
            inertia: tensor { xx: 0.3206, yy: 0.239, zz: 0.37, xy: 0.0276, yz: 0.0602, zx: 0.0316 }[kg * m ^ 2],
            points: [
                hook = (0.5, 0.25, -0.2),
                tip = (-0.3, 0.2, 0.4),
                wall = world(1.5, 2, -1),
                _foot = (-0.4, 0.3, 0.1),
                _nail = world(0.5, -1, 2),
                _far = (-0.2, -0.1, 0.5),
            ],
            fields: [weight = mass * world(0, -9.80665, 0), electric = world(3, -2, 4).at((0.3, -0.4, 0.2))],
            forces: [pushed = push.at(tip), spring = (30 * (wall.position() - hook.position())).at(hook)],
            moments: [twisted = twist],
            reactions: $reactions,
            outputs: $outputs,
        });
    };
}

/// In the plane.
macro_rules! plate {
    ($name:ident, [$($motion:tt)*], $reactions:tt, $outputs:tt) => {
        newton_euler::rigid_body!($name {
            motion: $($motion)*,
            inputs: [push = body(_, _)[N], twist[N * m]],
            mass: 1.9[kg],
            inertia: 0.37[kg * m ^ 2],
            points: [
                hook = (0.5, 0.25),
                tip = (-0.3, 0.2),
                wall = world(1.5, 2),
                _foot = (-0.4, 0.3),
                _nail = world(0.5, -1),
            ],
            fields: [weight = mass * world(0, -9.80665), electric = world(3, -2).at((0.3, -0.4))],
            forces: [pushed = push.at(tip), spring = (30 * (wall.position() - hook.position())).at(hook)],
            moments: [twisted = twist],
            reactions: $reactions,
            outputs: $outputs,
        });
    };
}

block!(Free, [spatial], [], []);
block!(
    Guided,
    [translation],
    [guide = moment(world(_, _, _))],
    [reactions]
);
block!(
    Top,
    [fixed_point(_foot).at(_nail)],
    [hold = world(_, _, _).at(_foot)],
    [reactions]
);
block!(
    Shaft,
    [fixed_axis(_foot, body(1, -2, 2)).at(_nail)],
    [
        hold = body(_, _, _).at(_foot),
        slide = body(0, _, _).at(_far),
    ],
    [reactions]
);
newton_euler::rigid_body!(Compass {
    motion: rotation,
    inputs: [push = body(_, _, _)[N], twist = body(_, _, _)[N * m]],
    inertia: tensor {
        xx: 0.3206,
        yy: 0.239,
        zz: 0.37,
        xy: 0.0276,
        yz: 0.0602,
        zx: 0.0316
    }[kg * m ^ 2],
    points: [tip = (-0.3, 0.2, 0.4)],
    fields: [electric = world(3, -2, 4).at((0.3, -0.4, 0.2))],
    forces: [pushed = push.at(tip)],
    moments: [twisted = twist],
});

plate!(Plate, [planar], [], []);
plate!(
    Slide,
    [planar_translation],
    [guide = moment(_)],
    [reactions]
);
plate!(
    Crank,
    [pivot(_foot).at(_nail)],
    [hold = body(_, _).at(_foot)],
    [reactions]
);

newton_euler::rigid_body!(Stick {
    motion: rod(body(2, -1, 2)),
    inputs: [
        push = world(_, _, _)[N],
        thrust[N],
        twist = world(_, _, _)[N * m]
    ],
    inertia: compose([
        point(0.5[kg]).at((0.6, -0.3, 0.6)),
        point(0.3[kg]).at((-0.4, 0.2, -0.4)),
        point(1.1[kg]).at((0.2, -0.1, 0.2)),
    ]),
    points: [
        hook = (1, -0.5, 1),
        tip = (-0.8, 0.4, -0.8),
        wall = world(1.5, 2, -1),
    ],
    fields: [
        weight = mass * world(0, -9.80665, 0),
        electric = world(3, -2, 4).at(tip)
    ],
    forces: [
        pushed = (push + thrust * axis).at(tip),
        spring = (30 * (wall.position() - hook.position())).at(hook),
    ],
    moments: [twisted = axis.cross(twist).cross(axis)],
});
