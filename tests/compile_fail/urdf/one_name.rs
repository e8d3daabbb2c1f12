use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "one_name.urdf",
});

fn main() {}
