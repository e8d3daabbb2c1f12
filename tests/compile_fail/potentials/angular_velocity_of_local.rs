use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    locals: [spin = 3 * angular_velocity],
    potentials: [coil = 2[N * m * s] * spin],
});

fn main() {}
