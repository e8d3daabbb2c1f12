use newton_euler::rigid_system;

rigid_system!(Boom {
    inputs: [torque[N * m]],
    bodies: [
        mast { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2], points: [top = (0, 0, 1)] },
        boom { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2], points: [tip = (0, 0, 1)] },
    ],
    joints: [
        foot = weld(world(0, 0, 0), mast.G),
        slew = revolute(mast.top, boom.G, body(0, 0, 1)).driven(0.1[rad / s] * t),
    ],
    outputs: [reactions, energy, taylor, mass_matrix, jacobian(boom.tip), inverse],
});

fn main() {}
