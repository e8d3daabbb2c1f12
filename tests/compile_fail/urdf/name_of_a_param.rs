use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/name_of_a_param.urdf",
    params: [arm],
});

fn main() {}
