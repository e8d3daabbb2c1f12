use newton_euler::rigid_system;

rigid_system!(Arm {
    mjcf: "../compile_fail/mjcf/groups_of_mass.xml",
});

fn main() {}
