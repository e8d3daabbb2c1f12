use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/delayed_motor.xml",
});

fn main() {}
