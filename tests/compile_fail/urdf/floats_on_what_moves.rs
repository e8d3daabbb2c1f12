use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/floats_on_what_moves.urdf",
});

fn main() {}
