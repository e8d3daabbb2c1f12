use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/out_of_range.urdf",
});

fn main() {}
