use newton_euler::rigid_body;

rigid_body!(Crate {
    motion: planar,
    mass: 2[kg],
    inertia: 0.4[kg * m ^ 2].along(body(0, 1)),
});

fn main() {}
