use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/one_name.urdf",
});

fn main() {}
