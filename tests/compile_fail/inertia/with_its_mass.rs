use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: spatial,
    inertia: sphere(0.1[m]).mass(2[kg]),
});

fn main() {}
