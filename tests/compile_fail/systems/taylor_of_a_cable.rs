use newton_euler::rigid_system;

rigid_system!(Swing {
    motion: planar,
    bodies: [
        arm { mass: 1.2[kg], inertia: 0.04[kg * m ^ 2], points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), arm.hinge),
        rope = cable(world(0, 1), arm.tip, 0.9[m], 400[N / m]),
    ],
    outputs: [taylor],
});

fn main() {}
