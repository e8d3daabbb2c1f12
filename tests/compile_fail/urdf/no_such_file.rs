use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_such_file.urdf",
});

fn main() {}
