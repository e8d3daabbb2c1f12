use newton_euler::rigid_body;

rigid_body!(Crate {
    motion: spatial,
    mass: 2[kg],
    inertia: box(0.1[m], 0.2[m], 0.4[m]),
});

fn main() {}
