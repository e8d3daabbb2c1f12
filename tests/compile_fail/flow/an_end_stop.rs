use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5[m])],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    moments: [stop = -5[N * m] * (1 + ((attitude - 2) / 0.01).tanh())],
    outputs: [flow],
});

fn main() {}
