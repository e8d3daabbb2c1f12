use newton_euler::rigid_system;

rigid_system!(Leaking {
    motion: planar,
    bodies: [bob { mass: 1[kg] - 0.1[kg / s] * t, inertia: 1[kg * m ^ 2], points: [pin = (0, 1)] }],
    joints: [hook = revolute(world(0, 0), bob.pin)],
    outputs: [energy, regressor],
});

fn main() {}
