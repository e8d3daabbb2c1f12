use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 1[kg],
    inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
    points: [tip = (1, 0, 0)[m]],
    forces: [push = body(0, 0, 1[N]).at(tip)],
});

// one vector of three components is a mistake in the vector
rigid_body!(Disc {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});

fn main() {}
