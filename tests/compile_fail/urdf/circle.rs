use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "circle.urdf",
});

fn main() {}
