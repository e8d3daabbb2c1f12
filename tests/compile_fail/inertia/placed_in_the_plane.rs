use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2].at(p),
    points: [p = (0.1, 0)[m]],
});

fn main() {}
