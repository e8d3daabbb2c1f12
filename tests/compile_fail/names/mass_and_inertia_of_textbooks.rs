use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: m,
    inertia: J,
});

fn main() {}
