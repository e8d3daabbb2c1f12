use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    inputs: [command[rad / s]],
    states: [turn[rad], reach[m], speed[m / s], lift[m]],
    rates: [
        turn = command,
        reach = speed,
        speed = (0.2[m] * shoulder.angular_velocity - speed) / 0.1[s],
        lift = 0.1[m / s] * wrong,
    ],
    bodies: [
        arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m]] },
        boom { mass: 1[kg], inertia: 0.1[kg * m ^ 2] },
        hand { mass: 1[kg], inertia: 0.1[kg * m ^ 2] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), arm.hinge).driven(0.5 * turn),
        rail = prismatic(arm.hinge, boom.G, body(1, 0)).driven(0.1[m] + reach),
        fork = prismatic(boom.G, hand.G, body(1, 0)).driven(lift),
    ],
    outputs: [reactions],
});

fn main() {}
