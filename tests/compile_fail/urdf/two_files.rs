use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/two_files.urdf",
    urdf: "../compile_fail/urdf/two_files.urdf",
});

fn main() {}
