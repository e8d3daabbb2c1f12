use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "out_of_range.urdf",
});

fn main() {}
