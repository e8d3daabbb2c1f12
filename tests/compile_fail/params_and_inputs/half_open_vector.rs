use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    inputs: [wind = world(_, 0)[m / s]],
    forces: [push = 2[N * s / m] * wind],
});

fn main() {}
