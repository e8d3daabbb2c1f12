use newton_euler::rigid_system;

rigid_system!(Arm {
    inputs: [torque[N * m]],
    bodies: [
        arm { mass: 0.3[kg], inertia: sphere(0.1[m]), points: [p = (-0.1, 0, 0), q = (0.1, 0, 0)] },
        hand { mass: 0.1[kg], inertia: sphere(0.1[m]), points: [p = (0.15, 0, 0)] },
    ],
    joints: [
        ball = spherical(world(0, 0, 0), arm.p),
        wrist = revolute(arm.q, hand.p, body(0, 0, 1)),
    ],
    drives: [
        motor = moment(arm.body(0, 0, torque)).on(ball),
        second = moment(torque).on(wrist),
        third = torque.on(ball.angle),
    ],
});

fn main() {}
