use newton_euler::rigid_body;

rigid_body!(Door {
    motion: fixed_axis(lower, body(0, 0, 1)),
    mass: 20[kg],
    inertia: principal(7, 8, 1.5)[kg * m ^ 2],
    points: [lower = (-0.4, 0, -0.8), upper = (-0.4, 0, 0.8)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    reactions: [a = body(_, _, 0).at(lower), b = body(_, _, 0).at(upper)],
});

fn main() {}
