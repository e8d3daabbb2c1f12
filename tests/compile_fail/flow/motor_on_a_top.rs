use newton_euler::rigid_body;

rigid_body!(Top {
    motion: fixed_point(tip),
    mass: 0.2[kg],
    inertia: principal(2e-4, 2e-4, 1e-4),
    points: [tip = (0, 0, -0.04[m])],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    moments: [motor = body(0, 0, 0.01)],
    outputs: [flow],
});

fn main() {}
