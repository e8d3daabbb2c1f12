use newton_euler::rigid_body;

rigid_body!(Arm {
    motion: pivot(pin),
    params: [torque = 3[N * m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5[m])],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    moments: [motor = torque],
    outputs: [flow],
});

fn main() {}
