use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    locals: [p = position],
    forces: [pull = -3[N / m] * body(p.x, p.y, p.z)],
});

fn main() {}
