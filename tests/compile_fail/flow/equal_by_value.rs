use newton_euler::rigid_body;

rigid_body!(Satellite {
    motion: rotation,
    params: [a = 0.3, b = 0.3, c = 0.1],
    inertia: principal(a, b, c),
    moments: [motor = body(0, 0, 0.2)],
    outputs: [flow],
});

fn main() {}
