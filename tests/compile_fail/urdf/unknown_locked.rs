use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/unknown_locked.urdf",
    locked: [swnig = 0, mount = 0, turn = 0, turn = 1],
});

fn main() {}
