use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "many.urdf",
});

fn main() {}
