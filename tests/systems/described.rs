//! Descriptions of the systems in `tests/reference/systems`.

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
            points: [hinge = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [energy, reactions],
});

rigid_system!(CartPole {
    motion: planar,
    inputs: [push[N]],
    bodies: [
        cart {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2]
        },
        bar {
            mass: 0.3[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [foot = (0, -0.5)[m]]
        },
    ],
    joints: [
        track = prismatic(world(0, 0), cart.G, body(1, 0)),
        pole = revolute(cart.G, bar.foot),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    drives: [motor = push.on(track)],
    outputs: [energy, reactions],
});

rigid_system!(Furuta {
    inputs: [torque[N * m]],
    bodies: [
        arm {
            mass: 0.3[kg],
            inertia: principal(1e-4, 1.2e-3, 1.2e-3),
            points: [hub = (-0.1, 0, 0), tip = (0.1, 0, 0)],
        },
        pole {
            mass: 0.12[kg],
            inertia: principal(9e-4, 9e-4, 2e-5),
            points: [pin = (0, 0, 0.15)],
        },
    ],
    joints: [
        yaw = revolute(world(0, 0, 0), arm.hub, body(0, 0, 1)),
        swing = revolute(arm.tip, pole.pin, body(1, 0, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(yaw)],
    outputs: [energy, reactions],
});

rigid_system!(BallDouble {
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: principal(0.04, 0.045, 0.012)[kg * m ^ 2],
            points: [top = (0, 0, 0.3)[m], end = (0, 0, -0.3)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.022, 0.006)[kg * m ^ 2],
            points: [top = (0, 0, 0.25)[m]],
        },
    ],
    joints: [
        first = spherical(world(0, 0, 0), upper.top),
        second = spherical(upper.end, lower.top),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, reactions],
});

rigid_system!(Satellite {
    inputs: [torque_x[N * m], torque_y[N * m], torque_z[N * m]],
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
        motor_x = torque_x.on(spin_x),
        motor_y = torque_y.on(spin_y),
        motor_z = torque_z.on(spin_z),
    ],
    outputs: [energy, reactions],
});

rigid_system!(Ur5 {
    inputs: [
        drives_1[N * m],
        drives_2[N * m],
        drives_3[N * m],
        drives_4[N * m],
        drives_5[N * m],
        drives_6[N * m],
    ],
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
        a = drives_1.on(pan),
        b = drives_2.on(lift),
        c = drives_3.on(elbow),
        d = drives_4.on(wrist_1),
        e = drives_5.on(wrist_2),
        f = drives_6.on(wrist_3),
    ],
    outputs: [energy, reactions],
});

// A = 12 and C = 9 of hub and rotor, without the rotor about 3; the rotor has 0.6 about its axis
rigid_system!(DualSpin {
    bodies: [
        hub {
            mass: 50[kg],
            inertia: principal(11.6, 11.6, 9)[kg * m ^ 2]
        },
        rotor {
            mass: 3[kg],
            inertia: principal(0.4, 0.4, 0.6)[kg * m ^ 2]
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.G, rotor.G, body(0, 0, 1))
    ],
    outputs: [energy, momentum],
});
