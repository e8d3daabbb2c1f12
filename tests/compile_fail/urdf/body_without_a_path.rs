use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: small,
    bodies: [hand { points: [palm = (0, 0, 0.1)] }],
});

fn main() {}
