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

rigid_body!(InAngles {
    motion: translation,
    mass: 1<kg>,
    forces: [
        push = world(3<kg * m / s ^ 2>, if t < 2 { 1[N] } else { 2[N] }, 0),
        late = if t > 1{s} { world((1){N}, 0, 0) } else { world(0, 1.N, 0) },
    ],
});

rigid_body!(InQuotes {
    motion: translation,
    mass: "3 kg",
    params: [k = "2.5", c = "no number"],
    forces: [push = k * world(1, c, 0)],
});

fn main() {}
