use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "name_of_a_param.urdf",
    params: [arm],
});

fn main() {}
