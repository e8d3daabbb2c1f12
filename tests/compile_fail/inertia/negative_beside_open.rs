newton_euler::rigid_body!(Rod {
    motion: rotation,
    params: [spin[kg * m ^ 2]],
    inertia: principal(-1, 2, spin),
});

fn main() {}
