//! One description twice: with its numbers as constants, and as parameters.

macro_rules! craft {
    ($name:ident, $params:tt, $m:tt, [$xx:tt, $yy:tt, $zz:tt, $xy:tt, $yz:tt, $zx:tt],
     [$px:tt, $py:tt, $pz:tt], $drag:tt, $stiffness:tt, $slow:tt) => {
        newton_euler::rigid_body!($name {
            motion: spatial,
            params: $params,
            inputs: [
                push = body(_, _, _)[N],
                pull = world(_, _, _)[N],
                wind = world(_, _, _)[m / s],
                turn = body(_, _, _)[N * m],
                twist = world(_, _, _)[N * m],
                throttle,
            ],
            mass: $m,
            inertia: tensor {
                xx: $xx,
                yy: $yy,
                zz: $zz,
                xy: $xy,
                yz: $yz,
                zx: $zx
            },
            points: [
                tip = ($px, $py, $pz),
                tail = (-0.6, 0.1, -0.2),
                hook = (0.3, 0, 0.5),
                mast = world(2, -1, 3),
                wall = world(-1, 0.5, 1),
            ],
            pole: tail,
            locals: [
                air = tail.velocity() - wind,
                gain = if throttle < 0.5 && !(position.in_world().z > 4) {
                    2 * throttle
                } else {
                    1 + throttle * throttle
                },
            ],
            reactions: [held = pull.at(wall), clamped = moment(0.5 * turn)],
            joint_forces: [linked = (2 * push).at(wall)],
            joint_moments: [hinged = body(0.25, 0, -0.5)],
            forces: [
                pushed = push.at(tip),
                pulled = pull.at(tail),
                drag = (-$drag * air.norm() * air).at(tail),
                spring = ($stiffness * (mast.position() - hook.position())).at(hook),
                jet = (gain * body(0, 3, 4)).at(tip),
            ],
            moments: [
                turned = turn,
                twisted = twist,
                damped = -$slow * angular_velocity,
            ],
            fields: [
                weight = mass * world(0, 0, -9.80665),
                lifted = world(0.5, 0, 2).at(hook),
                magnet = moment(body(1, 2, 3).cross(world(0.1, 0.2, 0.3))),
            ],
            outputs: [energy, momentum, balance],
        });
    };
}

craft!(
    Baked,
    [],
    2.5,
    [1.3, 1.7, 2.1, (-0.12), (-0.05), 0.07],
    [0.4, (-0.2), 0.1],
    0.8,
    12.5,
    0.3
);
craft!(
    Parametric,
    [
        m = 2.5,
        xx = 1.3,
        yy = 1.7,
        zz = 2.1,
        xy = -0.12,
        yz = -0.05,
        zx = 0.07,
        px = 0.4,
        py = -0.2,
        pz = 0.1,
        c = 0.8,
        k = 12.5,
        b = 0.3
    ],
    m,
    [xx, yy, zz, xy, yz, zx],
    [px, py, pz],
    c,
    k,
    b
);
