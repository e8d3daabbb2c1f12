use newton_euler::rigid_system;

rigid_system!(Bob {
    motion: planar,
    bodies: [bob { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }],
    joints: [rod = link(world(0, 0), bob.G, 1[m])],
});

fn main() {}
