use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf,
});

fn main() {}
