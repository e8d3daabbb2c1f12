use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "planar_motion.urdf",
    motion: planar,
});

fn main() {}
