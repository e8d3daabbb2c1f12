use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: rotation,
    inertia: sphere(0.1[m]),
});

fn main() {}
