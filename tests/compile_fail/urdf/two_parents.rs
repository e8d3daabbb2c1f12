use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "two_parents.urdf",
});

fn main() {}
