use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/damped_free_joint.xml",
});

fn main() {}
