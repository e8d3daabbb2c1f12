use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/misspelt_flag.xml",
});

fn main() {}
