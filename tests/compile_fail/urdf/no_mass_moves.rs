use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_mass_moves.urdf",
});

fn main() {}
