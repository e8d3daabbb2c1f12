use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    inputs: [wind[m / s] = world(_, _, _)],
    forces: [drag = 0.2[N * s / m] * (wind - velocity)],
});

fn main() {}
