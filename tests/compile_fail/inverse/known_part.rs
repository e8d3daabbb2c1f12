use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: rotation,
    inertia: principal(1, 2, 2.5)[kg * m ^ 2],
    moments: [motor = body(0.5, 0, _)],
    outputs: [inverse],
});

fn main() {}
