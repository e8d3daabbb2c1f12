use newton_euler::rigid_body;

rigid_body!(Door {
    motion: pivot(hinge),
    mass: 1[kg],
    inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
    points: [hinge = (0, 0, 1)[m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});

fn main() {}
