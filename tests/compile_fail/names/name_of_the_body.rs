use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    moments: [brake = -1[N * m * s] * Wheel.angular_velocity],
    forces: [drag = -1[N * s / m] * self.velocity],
});

fn main() {}
