use newton_euler::rigid_body;

rigid_body!(Needle {
    motion: rotation,
    inertia: principal(0.9e-9, 1, 1)[kg * m ^ 2],
});

fn main() {}
