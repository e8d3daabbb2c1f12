use newton_euler::rigid_system;

rigid_system!(Cup {
    mjcf: "../compile_fail/mjcf/no_independent_motion.xml",
});

fn main() {}
