use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_axis.urdf",
});

fn main() {}
