use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    params: [a = 1[N]],
    forces: [push = (a * 2).at(G) * world(1, 0)],
});

fn main() {}
