use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    forces: [spring = -3[N / m] * altitude * world(0, 0, 1)],
});

fn main() {}
