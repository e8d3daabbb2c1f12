use newton_euler::rigid_system;

rigid_system!(Pendulum {
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.22, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

// the other mistake is reported as well
rigid_system!(Cart {
    bodies: [
        cart { mass: 1[kg], inertia: 0.1[kg * m ^ 2] },
        bob { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0, 1[m])] },
    ],
    joints: [rail = prismatic(world(0, 0), cart.G, body(1, 0)), swing = revolute(cart.G, bob.pn)],
});

fn main() {}
