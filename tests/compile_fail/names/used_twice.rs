use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    locals: [a = 2 * v, b = 3 * v],
    moments: [motor = a * b * 1[N * m]],
});

fn main() {}
