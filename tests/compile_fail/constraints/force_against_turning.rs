use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    constraints: [upright = attitude],
    reactions: [push = world(0, _)],
});

fn main() {}
