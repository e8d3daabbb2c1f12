use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/two_parents.urdf",
});

fn main() {}
