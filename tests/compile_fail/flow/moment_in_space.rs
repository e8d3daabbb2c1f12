use newton_euler::rigid_body;

rigid_body!(Satellite {
    motion: rotation,
    inertia: principal(0.3, 0.2, 0.1),
    moments: [motor = body(0, 0, 0.2)],
    outputs: [flow],
});

fn main() {}
