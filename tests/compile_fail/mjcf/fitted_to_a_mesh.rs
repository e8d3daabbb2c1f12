use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/fitted_to_a_mesh.xml",
});

fn main() {}
