use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: spatial,
    mass: 1[kg],
    inertia: tensor { xx: 1; yy: 1; zz: 1 },
    forces: [push = body(1[N]; 0; 0)],
});

fn main() {}
