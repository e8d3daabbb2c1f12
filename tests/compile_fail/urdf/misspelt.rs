use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/misspelt.urdf",
});

fn main() {}
