use newton_euler::rigid_system;

rigid_system!(Arm {
    bodies: [
        upper { mass: 2[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2] },
        lower { mass: 1[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2] },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), upper.G, body(0, 0, 1)).at((0, 0, 0)[m]),
        elbow = revolute(upper.G, lower.G, body(0, 1, 0)),
    ],
});

fn main() {}
