use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "negative_mass.urdf",
});

fn main() {}
