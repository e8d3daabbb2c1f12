use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "another_format.urdf",
});

fn main() {}
