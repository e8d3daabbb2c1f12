newton_euler::rigid_body!(Rod {
    motion: fixed_point(G),
    inertia: principal(1e-18, 1, 1)[kg * m ^ 2],
    mass: 1[kg],
});

fn main() {}
