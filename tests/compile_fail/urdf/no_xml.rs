use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_xml.urdf",
});

fn main() {}
