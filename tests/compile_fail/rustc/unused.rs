#![deny(unused_variables)]

use newton_euler::rigid_body;

// a claim at compile time: rustc proposes constants that are called nearly as an unused name
const _: () = assert!(0.5 < 0.7);

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm = 0.5[m], span = 0.7[m]],
    inputs: [thrust[N], rudder, c],
    points: [tip = (arm, 0), tail = (-arm, 0)],
    locals: [half = thrust / 2],
    forces: [push = body(0, thrust).at(tip)],
});

fn main() {}
