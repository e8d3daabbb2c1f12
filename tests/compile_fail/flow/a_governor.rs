use newton_euler::rigid_body;

rigid_body!(Governed {
    motion: rotation,
    locals: [excess = angular_velocity.in_body().z - 5[rad / s]],
    inertia: principal(1, 1, 2)[kg * m ^ 2],
    moments: [governor = -1[N * m * s] * (excess + excess.powi(2).sqrt()) * body(0, 0, 1)],
    outputs: [flow],
});

fn main() {}
