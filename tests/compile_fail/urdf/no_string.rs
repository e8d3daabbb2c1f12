use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: robot.urdf,
});

fn main() {}
