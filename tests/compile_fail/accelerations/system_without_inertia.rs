use newton_euler::rigid_system;

rigid_system!(Cart {
    motion: planar,
    bodies: [cart { mass: 2[kg], forces: [freed = mass * acceleration] }],
    joints: [rail = prismatic(world(0, 0), cart.G, body(1, 0))],
});

fn main() {}
