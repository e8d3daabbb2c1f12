use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: spatial,
    mass: 1(kg),
    inertia: principal(1, 1, 1)(kg * m ^ 2),
    forces: [push = body(0, 0, 2(3 + t))],
    fields: [weight = mass * world(0, 0, -9.81(m / s^2))],
});

fn main() {}
