use newton_euler::rigid_system;

rigid_system!(Bob {
    motion: planar,
    bodies: [bob { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }],
    joints: [falls = free(bob)],
    cables: [rope = cable(world(0, 2)[m], bob.G, 1[m], 300[N / m])],
});

fn main() {}
