use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: pivot(pin),
    params: [length[m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, length)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [constant],
});

rigid_body!(Shuttlecock {
    motion: translation,
    mass: 2[kg],
    forces: [drag = -0.1[N * s ^ 2 / m ^ 2] * velocity.norm() * velocity],
    outputs: [constant],
});

fn main() {}
