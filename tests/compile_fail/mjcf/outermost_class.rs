use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/outermost_class.xml",
});

fn main() {}
