use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: tensor { xx: 0.02, yy: 0.03, zz: 0.04, xz: 0.001 }[kg * m ^ 2],
});

fn main() {}
