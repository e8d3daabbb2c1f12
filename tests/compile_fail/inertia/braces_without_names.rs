use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: tensor { 1, 2, 2.5 }[kg * m ^ 2],
});

fn main() {}
