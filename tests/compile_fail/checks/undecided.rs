use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: pivot(pin),
    inputs: [torque[N * m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    moments: [motor = torque],
    checks: [
        doubled = ((2 * attitude).sin() == 2 * attitude.sin() * attitude.cos()).given(angle = 0.3[rad]),
    ],
});

fn main() {}
