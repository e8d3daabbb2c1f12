use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/no_mass_moves.urdf",
});

fn main() {}
