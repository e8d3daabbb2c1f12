use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "missing.urdf",
});

fn main() {}
