use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "mimic.urdf",
});

fn main() {}
