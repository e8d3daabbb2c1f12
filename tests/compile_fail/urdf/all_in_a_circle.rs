use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/all_in_a_circle.urdf",
});

fn main() {}
