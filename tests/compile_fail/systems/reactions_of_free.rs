use newton_euler::rigid_system;

rigid_system!(Pair {
    motion: planar,
    bodies: [
        upper { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [b = (1, 0)] },
        lower { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-1, 0)] },
    ],
    joints: [flight = free(upper), elbow = revolute(upper.b, lower.a)],
    outputs: [reactions(flight)],
});

fn main() {}
