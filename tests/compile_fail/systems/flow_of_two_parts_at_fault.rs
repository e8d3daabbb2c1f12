use newton_euler::rigid_system;

rigid_system!(Parts {
    inputs: [push[N]],
    bodies: [
        hub { mass: 50[kg], inertia: principal(10, 11, 9) },
        wheel { mass: 3[kg], inertia: principal(0.4, 0.4, 0.6) },
        cart { mass: 1[kg], inertia: principal(1, 1, 1), forces: [motor = world(push, 0, 0)] },
        stone { mass: 1[kg], inertia: principal(1, 2, 2) },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.G, wheel.G, body(0, 0, 1)),
        rail = prismatic(world(0, 0, 0), cart.G, world(1, 0, 0)),
        flight = free(stone),
    ],
    outputs: [flow],
});

fn main() {}
