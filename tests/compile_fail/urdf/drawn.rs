use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../urdf/small.urdf",
    drawing: zero_pose,
    bodies: [load { mass: 1[kg], inertia: sphere(0.1[m]) }],
    joints: [orbit = free(load)],
});

fn main() {}
