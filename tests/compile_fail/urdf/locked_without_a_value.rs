use newton_euler::prelude::*;

rigid_system!(Robot {
    locked: [finger],
    bodies: [arm { mass: 1[kg], inertia: sphere(0.1[m]) }],
    joints: [root = free(arm)],
});

fn main() {}
