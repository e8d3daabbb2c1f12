use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "unknown_link.urdf",
});

fn main() {}
