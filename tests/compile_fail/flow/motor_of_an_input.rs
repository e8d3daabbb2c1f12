use newton_euler::rigid_body;

rigid_body!(Satellite {
    motion: rotation,
    inputs: [torque[N * m]],
    inertia: principal(0.3, 0.3, 0.1),
    moments: [motor = body(0, 0, torque)],
    outputs: [flow],
});

fn main() {}
