use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/neither_true_nor_false.xml",
});

fn main() {}
