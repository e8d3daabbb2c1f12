use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m], heel = (0.2, -0.3)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    reactions: [hold = world(_, _)[N][N].at(pin)],
    outputs: [reactions],
});

fn main() {}
