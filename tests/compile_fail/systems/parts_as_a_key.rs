use newton_euler::rigid_system;

rigid_system!(Cart {
    motion: planar,
    parts: [
        cart { mass: 2[kg], inertia: 1[kg * m ^ 2] },
        bob { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0, 1[m])] },
    ],
    links: [
        rail = prismatic(world(0, 0), cart.G, world(1, 0)),
        swing = revolute(cart.G, bob.pin),
    ],
});

fn main() {}
