use newton_euler::rigid_system;

rigid_system!(Arm {
    bodies: [upper { mass: 1[kg], inertia: principal(1, 2, 2) }],
    joints: [shoulder = revolute(world(0, 0, 0), upper.G, body(0, 0, 1))],
    outputs: [jacobian(shoulder)],
});

fn main() {}
