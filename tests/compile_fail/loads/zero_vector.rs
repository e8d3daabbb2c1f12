newton_euler::rigid_body!(Crate {
    motion: spatial,
    mass: 2,
    inertia: principal(1, 2, 2),
    locals: [nowhere = body(0, 0, 0)],
    forces: [push = world(1, 0, 0).at(nowhere)],
});

fn main() {}
