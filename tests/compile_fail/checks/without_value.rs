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
        ratio = (1[N * m] / torque > 0).given(torque = 0[N * m]),
        root = (((angular_velocity / 1[rad / s]) - 2).sqrt() < 1).given(angular_velocity = 1[rad / s]),
    ],
});

fn main() {}
