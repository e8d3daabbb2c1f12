use newton_euler::rigid_body;

rigid_body!(Bar {
    mass: 1[kg],
    inertia: rod(1[m]),
    moments: [motor = 0.1[N * m]],
});

fn main() {}
