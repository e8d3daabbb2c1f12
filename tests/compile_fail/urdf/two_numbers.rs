use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "two_numbers.urdf",
});

fn main() {}
