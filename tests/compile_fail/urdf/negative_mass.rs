use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/negative_mass.urdf",
});

fn main() {}
