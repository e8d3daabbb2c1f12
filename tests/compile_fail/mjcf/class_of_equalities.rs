use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/class_of_equalities.xml",
});

fn main() {}
