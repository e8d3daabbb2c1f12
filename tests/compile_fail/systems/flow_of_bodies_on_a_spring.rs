use newton_euler::rigid_system;

rigid_system!(Carts {
    motion: planar,
    bodies: [first { mass: 1[kg] }, second { mass: 1[kg] }],
    joints: [
        left = prismatic(world(0, 0), first.G, world(1, 0)),
        right = prismatic(world(1, 0), second.G, world(1, 0)),
    ],
    forces: [spring = (3[N / m] * (right.position - left.position)).between(first.G, second.G)],
    outputs: [flow],
});

fn main() {}
