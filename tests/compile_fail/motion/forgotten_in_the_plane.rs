use newton_euler::rigid_body;

rigid_body!(Wheel {
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    moments: [brake = -0.2[N * m * s] * angular_velocity],
    outputs: [energy],
});

fn main() {}
