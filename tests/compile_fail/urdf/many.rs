use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/many.urdf",
});

fn main() {}
