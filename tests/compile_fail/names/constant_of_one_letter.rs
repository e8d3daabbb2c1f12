use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: M,
    inertia: principal(1, 1, 1)[kg * m ^ 2],
});

fn main() {}
