use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm = 0.5[m]],
    moments: [drag = -0.1[N / m] * arm ^ 2],
});

fn main() {}
