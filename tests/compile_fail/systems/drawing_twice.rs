use newton_euler::rigid_system;

rigid_system!(Arm {
    drawing: zero_pose,
    drawing: zero_pose,
    bodies: [
        upper { mass: 2[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2].at((0.2, 0, 0)[m]) },
        lower { mass: 1[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2].at((0.6, 0, 0)[m]) },
    ],
    joints: [
        shoulder = revolute(world, upper, (0, 0, 1)).at((0, 0, 0)[m]),
        elbow = revolute(upper, lower, (0, 1, 0)).at((0.4, 0, 0)[m]),
    ],
});

fn main() {}
