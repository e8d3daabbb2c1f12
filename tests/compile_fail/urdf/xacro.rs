use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/xacro.urdf",
});

fn main() {}
