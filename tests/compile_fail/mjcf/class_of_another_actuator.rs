use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/class_of_another_actuator.xml",
});

fn main() {}
