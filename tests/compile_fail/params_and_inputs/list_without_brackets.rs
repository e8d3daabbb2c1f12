use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    inputs: thrust[N], gust[m / s],
    forces: [push = thrust * body(0, 0, 1), drift = 0.1[N * s / m] * gust * body(1, 0, 0)],
});

fn main() {}
