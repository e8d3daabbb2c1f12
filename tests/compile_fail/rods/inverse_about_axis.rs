use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
    moments: [motor = world(0, 0, _)],
    outputs: [inverse],
});

fn main() {}
