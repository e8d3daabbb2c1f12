use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/locked_in_meters.urdf",
    locked: [swing = 1[m]],
});

fn main() {}
