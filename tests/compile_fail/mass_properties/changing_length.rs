use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: spatial,
    mass: 2[kg],
    inertia: sphere(0.1[m] + 0.01[m / s] * t),
});

fn main() {}
