use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_name.urdf",
});

fn main() {}
