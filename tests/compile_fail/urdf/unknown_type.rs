use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "unknown_type.urdf",
});

fn main() {}
