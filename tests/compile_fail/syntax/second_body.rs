use newton_euler::rigid_body;

rigid_body!(Pair {
    motion: spatial,
    mass: 1[kg],
    inertia: sphere(0.1[m]),
    other { mass: 2[kg], inertia: sphere(0.2[m]) },
});

rigid_body!(Single {
    ball { motion: spatial, mass: 1[kg], inertia: sphere(0.1[m]) },
});

fn main() {}
