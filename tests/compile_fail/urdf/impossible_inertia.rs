use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "impossible_inertia.urdf",
});

fn main() {}
