use newton_euler::rigid_body;

rigid_body!(Bead {
    motion: translation,
    mass: 1[kg],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [floor = position.in_world().z],
    reactions: [normal = world(0, 0, _)],
    outputs: [taylor],
});

fn main() {}
