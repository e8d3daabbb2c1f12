use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: spatial,
    mass: 1(kg),
    inertia: principal(1, 1, 1)(kg * m ^ 2),
    forces: [push = body(0, 0, 2(3 + t))],
    fields: [weight = mass * world(0, 0, -9.81(m / s^2))],
});

rigid_body!(InBraces {
    motion: planar,
    mass: 1{kg},
    inertia: 1[kg * m ^ 2],
    forces: [push = body(if t < 1[s] { 2[N] } else { 0[N] }, 3{kg * m / s ^ 2})],
});

fn main() {}
