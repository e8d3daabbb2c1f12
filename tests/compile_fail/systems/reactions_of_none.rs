use newton_euler::rigid_system;

rigid_system!(Pair {
    motion: planar,
    bodies: [
        upper { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-1, 0), b = (1, 0)] },
        lower { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-1, 0)] },
    ],
    joints: [shoulder = revolute(world(0, 0), upper.a), elbow = revolute(upper.b, lower.a)],
    outputs: [reactions()],
});

fn main() {}
