use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    moments: [brake = -0.1[1 / s] * inertia * angular_velocity],
});

fn main() {}
