use newton_euler::rigid_body;

rigid_body!(Disk {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    params: [c = 0.1[N * s / m]],
    points: [tip = (1, 0)[m]],
    forces: [
        air = -c * velocity(),
        drag = -c(velocity),
        brush = -c * velocity(tip),
        push = world(0, t() * 1[N / s]),
    ],
});

fn main() {}
