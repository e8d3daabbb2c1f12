use newton_euler::rigid_body;

rigid_body!(Crate {
    motion: spatial,
    mass: 2[kg],
    inertia: cuboid(0.1[m], 0.2[m], 0.4[m]).turned(body(0, 0, 1), 90[m]),
});

fn main() {}
