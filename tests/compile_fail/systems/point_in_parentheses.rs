use newton_euler::rigid_system;

rigid_system!(Arm {
    bodies: [
        upper { mass: 1[kg], inertia: principal(1, 2, 2), points: [tip = (0.3, 0, 0)] },
        lower { mass: 1[kg], inertia: principal(1, 2, 2) },
    ],
    joints: [
        shoulder = revolute((0, 0, 0), upper.G, body(0, 0, 1)),
        elbow = revolute(upper.tip, (0.1, 0, 0)[m], body(0, 0, 1)),
    ],
});

fn main() {}
