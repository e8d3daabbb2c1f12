use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: { principal(1, 1, 1)[kg * m ^ 2] },
});

rigid_body!(Block {
    motion: spatial,
    mass: [1[kg]],
    inertia: [sphere(1[m])],
});

fn main() {}
