use newton_euler::rigid_body;

rigid_body!(Door {
    motion: fixed_axis(lower, along),
    mass: 2[kg],
    inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],
    points: [lower = (-0.4, 0, -0.8)[m], upper = (-0.4, 0, 0.8)[m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    params: [along = body(0, 0, 0)],
});

fn main() {}
