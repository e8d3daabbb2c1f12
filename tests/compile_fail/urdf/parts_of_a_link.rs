use newton_euler::prelude::*;

rigid_system!(Robot {
    urdf: "../compile_fail/urdf/parts_of_a_link.urdf",
    bodies: [arm { inertia: compose([sphere(0.1[m]).mass(1[kg])]) }],
});

fn main() {}
