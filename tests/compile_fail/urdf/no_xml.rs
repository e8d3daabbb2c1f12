use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/no_xml.urdf",
});

fn main() {}
