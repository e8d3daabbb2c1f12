use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    inputs: [torque[N * m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    moments: [motor = torque],
    outputs: [flow],
});

fn main() {}
