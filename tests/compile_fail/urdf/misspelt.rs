use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "misspelt.urdf",
});

fn main() {}
