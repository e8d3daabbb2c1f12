use newton_euler::rigid_system;

rigid_system!(Crane {
    motion: planar,
    params: [cart = 2[m]],
    inputs: [push[N]],
    bodies: [
        cart { mass: 2[kg], params: [a = 1] },
        hook { mas: 1[kg], points: [eye = (0, 0.2)[m], mid = (0, 0.1, 0)] },
        load { mass: 30[N], inertia: 2[kg * m ^ 2], points: [ring = (0, 1)] },
        spare { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [
        rail = prismatic(world(0, 0), cart.G, body(0, 0)),
        cable = revolut(cart.G, hook.eye),
        sling = revolute(hook.mdi, load.ring),
    ],
    drives: [motor = push.on(rial), brake = push.on(sling)],
    forces: [wind = 2[N].between(load.rign, world(0, 0))],
    outputs: [energy, taylor],
});

fn main() {}
