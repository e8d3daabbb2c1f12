use newton_euler::{rigid_body, rigid_system};

rigid_body!(Block {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [floor = table(position.in_world().x, [0, 1][m], [1, 1][m])],
    reactions: [ground = world(0, _)],
});

rigid_system!(Carts {
    motion: planar,
    bodies: [cart { mass: 1[kg], inertia: 1[kg * m ^ 2] }],
    joints: [rail = prismatic(world(0, 0), cart.G, world(1, 0))],
    constraints: [floor = table(rail.position, [0, 1][m], [1, 1][m])],
});

fn main() {}
