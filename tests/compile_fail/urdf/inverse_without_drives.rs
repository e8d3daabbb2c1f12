use newton_euler::rigid_system;

rigid_system!(Pendulum {
    urdf: "../compile_fail/urdf/inverse_without_drives.urdf",
    outputs: [inverse],
});

fn main() {}
