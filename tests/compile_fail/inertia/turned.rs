use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: tensor { xx: 1, yy: 1, zz: 1, xy: 0.45, yz: 0.45, zx: 0.45 }[kg * m ^ 2],
});

fn main() {}
