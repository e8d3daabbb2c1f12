use newton_euler::rigid_system;

rigid_system!(Mechanism {
    inputs: [angle[rad], moving_angle[rad].moving, torque[N * m]],
    bodies: [
        arm { mass: 1[kg], inertia: principal(1, 1, 1), points: [tip = (0.1, 0, 0)] },
        pole { mass: 1[kg], inertia: principal(1, 1, 1), points: [pin = (0, 0, 0.15)] },
        ball { mass: 1[kg], inertia: principal(1, 1, 1) },
        slider { mass: 1[kg], inertia: principal(1, 1, 1) },
        other { mass: 1[kg], inertia: principal(1, 1, 1) },
        last { mass: 1[kg], inertia: principal(1, 1, 1) },
    ],
    joints: [
        yaw = revolute(world(0, 0, 0), arm.G, body(0, 0, 1)).driven(angle),
        swing = revolute(arm.tip, pole.pin, body(1, 0, 0)).driven(0.3 * yaw.angle),
        socket = spherical(pole.G, ball.G).driven(2[rad / s] * t),
        slide = prismatic(arm.G, slider.G, body(1, 0, 0)).driven(2[rad / s] * t),
        rail = cylindrical(arm.G, other.G, body(1, 0, 0)).driven(0.2[m]),
        spin = revolute(arm.G, last.G, body(1, 0, 0)).driven(moving_angle).driven(t),
    ],
    drives: [motor = torque.on(yaw), other_motor = torque.on(rail.angle)],
});

rigid_system!(Driven {
    inputs: [torque[N * m]],
    bodies: [
        arm { mass: 1[kg], inertia: principal(1, 1, 1), points: [tip = (0.1, 0, 0)] },
        pole { mass: 1[kg], inertia: principal(1, 1, 1) },
    ],
    joints: [
        yaw = revolute(world(0, 0, 0), arm.G, body(0, 0, 1)).driven(2[rad / s] * t),
        rail = cylindrical(arm.tip, pole.G, body(1, 0, 0)),
    ],
    drives: [motor = torque.on(yaw), open = _.on(yaw)],
    outputs: [inverse],
});

fn main() {}
