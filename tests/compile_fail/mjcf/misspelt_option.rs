use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/misspelt_option.xml",
});

fn main() {}
