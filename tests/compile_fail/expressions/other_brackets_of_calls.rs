use newton_euler::rigid_body;

rigid_body!(Ball {
    motion: spatial,
    mass: 1[kg],
    inertia: sphere{1[m]},
    points: [tip = (1, 0, 0)[m]],
    params: [rate = 1[1 / s]],
    forces: [
        push = body(table[t, [0, 1], [0, 1]], 0, (t * rate).sin[] * 1[N]).at{tip},
        drag = world(-velocity[0] * 1[N * s / m], 0, 0),
    ],
});

fn main() {}
