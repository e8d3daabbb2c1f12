use newton_euler::rigid_system;

rigid_system!(Furuta {
    inputs: [torque[N * m]],
    bodies: [
        arm {
            mass: 0.3[kg],
            inertia: cylinder(0.01[m], 0.2[m]),
            points: [hub = (-0.1, 0, 0), tip = (0.1, 0, 0)],
        },
        pole { mass: 0.1[kg], inertia: sphere(0.1[m]), points: [pin = (0.15, 0, 0)] },
    ],
    joints: [
        yaw = revolute(world(0, 0, 0), arm.hub, body(0, 0, 1)),
        swing = revolute(arm.tip, pole.pin, body(1, 0, 0)).turned(body(1, 0, 0), 2[m]),
    ],
    drives: [motor = torque.on(yaw)],
});

fn main() {}
