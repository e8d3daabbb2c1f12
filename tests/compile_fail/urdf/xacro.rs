use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "xacro.urdf",
});

fn main() {}
