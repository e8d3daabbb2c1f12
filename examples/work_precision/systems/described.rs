//! The systems, described: those of `tests/reference/systems`, under the drives that they have there.

use newton_euler::prelude::*;

rigid_system!(DoublePendulum {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

rigid_system!(Wheels {
    doc: "A satellite with three reaction wheels, each with a torque that stays.",
    bodies: [
        hub {
            mass: 120[kg],
            inertia: principal(12, 14, 9)[kg * m ^ 2],
            points: [px = (0.3, 0, 0), py = (0, 0.3, 0), pz = (0, 0, 0.3)],
        },
        wheel_x {
            mass: 4[kg],
            inertia: principal(0.035, 0.02, 0.02)[kg * m ^ 2]
        },
        wheel_y {
            mass: 4[kg],
            inertia: principal(0.02, 0.035, 0.02)[kg * m ^ 2]
        },
        wheel_z {
            mass: 4[kg],
            inertia: principal(0.02, 0.02, 0.035)[kg * m ^ 2]
        },
    ],
    joints: [
        orbit = free(hub),
        spin_x = revolute(hub.px, wheel_x.G, body(1, 0, 0)),
        spin_y = revolute(hub.py, wheel_y.G, body(0, 1, 0)),
        spin_z = revolute(hub.pz, wheel_z.G, body(0, 0, 1)),
    ],
    drives: [
        motor_x = (0.05[N * m]).on(spin_x),
        motor_y = (-0.02[N * m]).on(spin_y),
        motor_z = (0.03[N * m]).on(spin_z),
    ],
    outputs: [taylor],
});

rigid_system!(Arm {
    doc: "A UR5 under torques that stay.",
    bodies: [
        shoulder {
            mass: 3.7[kg],
            inertia: principal(0.010267495893, 0.010267495893, 0.00666)[kg * m ^ 2],
            points: [out = (0, 0.13585, 0)],
        },
        upper_arm {
            mass: 8.393[kg],
            inertia: principal(0.22689067591, 0.22689067591, 0.0151074)[kg * m ^ 2],
            points: [from = (0, 0, -0.28), out = (0, -0.1197, 0.145)],
        },
        forearm {
            mass: 2.275[kg],
            inertia: principal(0.049443313556, 0.049443313556, 0.004095)[kg * m ^ 2],
            points: [from = (0, 0, -0.25), out = (0, 0, 0.14225)],
        },
        first {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2],
            points: [out = (0, 0.093, 0)],
        },
        second {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2],
            points: [out = (0, 0, 0.09465)],
        },
        third {
            mass: 0.1879[kg],
            inertia: principal(0.0171364731454, 0.0171364731454, 0.033822)[kg * m ^ 2],
        },
    ],
    joints: [
        pan = revolute(world(0, 0, 0.089159)[m], shoulder.G, body(0, 0, 1)),
        lift = revolute(shoulder.out, upper_arm.from, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        elbow = revolute(upper_arm.out, forearm.from, body(0, 1, 0)),
        wrist_1 = revolute(forearm.out, first.G, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        wrist_2 = revolute(first.out, second.G, body(0, 0, 1)),
        wrist_3 = revolute(second.out, third.G, body(0, 1, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        motor_1 = (10[N * m]).on(pan),
        motor_2 = (-20[N * m]).on(lift),
        motor_3 = (15[N * m]).on(elbow),
        motor_4 = (2[N * m]).on(wrist_1),
        motor_5 = (-1[N * m]).on(wrist_2),
        motor_6 = (0.5[N * m]).on(wrist_3),
    ],
});
