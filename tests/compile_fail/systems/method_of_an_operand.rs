use newton_euler::rigid_system;

rigid_system!(Cart {
    motion: planar,
    inputs: [push[N], pull[N], torque[N * m]],
    bodies: [
        cart { mass: 2[kg] },
        pole { mass: 0.4[kg], inertia: 0.01[kg * m ^ 2], points: [pin = (0, -0.3)[m]] },
    ],
    joints: [
        rail = prismatic(world(0, 0), cart.G, body(1, 0)),
        swing = revolute(cart.G, pole.pin),
    ],
    drives: [motor = -push.on(rail), friction = -1[N * m] - torque.on(swing)],
    forces: [spring = 2 * -pull.between(cart.G, pole.G)],
    moments: [couple = -moment(torque).between(cart, pole)],
});

fn main() {}
