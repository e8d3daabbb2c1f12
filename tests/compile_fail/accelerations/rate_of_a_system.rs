use newton_euler::rigid_system;

rigid_system!(Cart {
    motion: planar,
    bodies: [cart { mass: 2[kg] }],
    joints: [rail = prismatic(world(0, 0), cart.G, body(1, 0))],
    states: [measured[m / s ^ 2]],
    rates: [measured = (cart.acceleration.in_world().x - measured) / 0.1[s]],
    drives: [held = (-2[kg] * measured).on(rail)],
});

fn main() {}
