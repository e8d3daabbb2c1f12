use newton_euler::rigid_body;

rigid_body!(Started {
    motion: rotation,
    inertia: principal(1, 1, 2)[kg * m ^ 2],
    moments: [motor = (1 + ((t - 10[s]) / 0.05[s]).tanh()) * body(0, 0, 1[N * m])],
    outputs: [flow],
});

fn main() {}
