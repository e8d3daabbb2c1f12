use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/no_links.urdf",
});

fn main() {}
