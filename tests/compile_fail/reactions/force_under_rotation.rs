use newton_euler::rigid_body;

rigid_body!(Satellite {
    motion: rotation,
    inertia: principal(1, 2, 3),
    reactions: [hold = world(_, _, _)],
});

fn main() {}
