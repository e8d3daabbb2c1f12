use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/unknown_link.urdf",
});

fn main() {}
