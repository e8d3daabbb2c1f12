use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_number.urdf",
});

fn main() {}
