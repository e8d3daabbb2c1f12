newton_euler::rigid_body!(Rod {
    motion: rotation,
    inertia: principal(1e-18, 1, 1)[kg * m ^ 2],
});

fn main() {}
