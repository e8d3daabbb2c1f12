use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/unknown_in_a_class.xml",
});

fn main() {}
