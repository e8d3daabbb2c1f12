use newton_euler::rigid_body;

rigid_body!(Ring {
    motion: spatial,
    mass: 2[kg],
    inertia: torus(0.1[m], 0.2[m]),
});

fn main() {}
