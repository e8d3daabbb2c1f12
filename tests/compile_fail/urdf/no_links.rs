use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "no_links.urdf",
});

fn main() {}
