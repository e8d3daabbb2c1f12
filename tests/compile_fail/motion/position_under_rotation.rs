use newton_euler::rigid_body;

rigid_body!(Top {
    motion: rotation,
    inertia: principal(0.2, 0.2, 0.1)[kg * m ^ 2],
    moments: [pull = body(0, 0, 1[N]).cross(position)],
});

fn main() {}
