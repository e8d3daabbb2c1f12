use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: j,
    params: [j = tensor { xx: 1, yy: 2, zz: 2.5 }[kg * m ^ 2]],
});

fn main() {}
