use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "two_files.urdf",
    urdf: "two_files.urdf",
});

fn main() {}
