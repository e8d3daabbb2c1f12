use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../urdf/no_such.urdf",
    bodies: [hand { points: [palm = (0, 0, 0.1)] }],
});

fn main() {}
