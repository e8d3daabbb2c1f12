use newton_euler::rigid_body;

rigid_body!(Top {
    motion: rotation,
    inertia: principal(0.2, 0.2, 0.1)[kg * m ^ 2],
    forces: [push = body(1, 0, 0).at(world(0, 0, 1))],
});

fn main() {}
