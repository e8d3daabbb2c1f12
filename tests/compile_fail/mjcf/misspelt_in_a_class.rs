use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/misspelt_in_a_class.xml",
});

fn main() {}
