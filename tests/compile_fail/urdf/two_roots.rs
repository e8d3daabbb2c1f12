use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "two_roots.urdf",
});

fn main() {}
