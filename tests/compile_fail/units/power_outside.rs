use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm = 0.5[m]],
    moments: [drag = -0.1[N / m] * arm ^ 2],
});

// Rust's `^` would take `length - rate * arm` together
rigid_body!(Drum {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm = 0.5[m], length = 1[m], rate = 1[1 / m]],
    moments: [drag = -0.1[N] * (length - rate * arm ^ 2) + unknown],
});

fn main() {}
