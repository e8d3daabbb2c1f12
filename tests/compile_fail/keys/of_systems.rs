use newton_euler::rigid_body;

rigid_body!(Rocket {
    bodies: [upper { mass: 1[kg], inertia: principal(1, 1, 1), points: [tip = (0.3, 0, 0)] }],
    joints: [shoulder = revolute(world(0, 0, 0), upper.tip, body(0, 0, 1))],
    drives: [motor = torque.on(shoulder)],
    inputs: [torque[N * m]],
});

fn main() {}
