use newton_euler::rigid_system;

rigid_system!(Bridge {
    motion: planar,
    bodies: [deck { mass: 5[kg], inertia: 1[kg * m ^ 2] }],
    joints: [bolts = weld(world(0, 0), deck.G)],
    outputs: [flow],
});

fn main() {}
