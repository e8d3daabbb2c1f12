use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: tensor { Ixx: 1, Iyy: 1, Izz: 1 }[kg * m ^ 2],
});

rigid_body!(Block {
    motion: spatial,
    mass: 1[kg],
    inertia: tensor([1, 0, 0], [0, 1, 0], [0, 0, 1]),
});

fn main() {}
