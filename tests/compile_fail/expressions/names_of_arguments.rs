use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(xx: 1, yy: 1, zz: 1),
    forces: [push = world(x: 1[N], y: 0, z: 0)],
});

fn main() {}
