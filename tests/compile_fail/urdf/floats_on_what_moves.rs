use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "floats_on_what_moves.urdf",
});

fn main() {}
