use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/no_flag_value.xml",
});

fn main() {}
