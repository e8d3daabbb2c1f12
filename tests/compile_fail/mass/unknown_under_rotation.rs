use newton_euler::rigid_body;

rigid_body!(Top {
    motion: rotation,
    inertia: principal(0.2, 0.2, 0.1)[kg * m ^ 2],
    fields: [weight = (mass * world(0, 0, -9.81[m / s ^ 2])).at((0, 0, 0.1))],
});

fn main() {}
