use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/planar_motion.urdf",
    motion: planar,
});

fn main() {}
