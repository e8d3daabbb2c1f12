use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: spatial,
    mass: 2[kg],
    inertia: sphere(10)[kg * m ^ 2],
});

fn main() {}
