use newton_euler::rigid_body;

rigid_body!(Top {
    motion: rotation,
    inertia: principal(0.2, 0.2, 0.1)[kg * m ^ 2],
    points: [tip = (0, 0, 0.1)],
    pole: tip,
});

fn main() {}
