use newton_euler::prelude::*;

rigid_body!(Plate {
    motion: planar,
    params: [a[m]],
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [a = (a / 2, 0)],
    forces: [push = world(1[N], 0).at(a)],
});

fn main() {}
