use newton_euler::rigid_system;

rigid_system!(Pair {
    motion: planar,
    bodies: [
        left { mass: 2[kg], inertia: 1[kg * m ^ 2] },
        right { mass: 2[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [rod_x = revolute(world(0, 0), left.G), floating = free(right)],
    constraints: [
        rod = right.G.position() - world(1, 0)[m],
        rod_y = rod_x.angle - floating.angle,
    ],
    outputs: [reactions],
});

fn main() {}
