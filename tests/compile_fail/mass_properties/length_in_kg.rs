use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: rotation,
    mass: 2[kg],
    inertia: sphere(0.1[kg]),
});

fn main() {}
