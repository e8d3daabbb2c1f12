use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/impossible_inertia.urdf",
});

fn main() {}
