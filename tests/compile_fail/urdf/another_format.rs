use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/another_format.urdf",
});

fn main() {}
