use newton_euler::rigid_body;

rigid_body!(Block {
    motion: planar_translation,
    mass: 1[kg],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [floor = position.in_world().y],
    reactions: [normal = world(0, _)],
    forces: [friction = world(-0.3 * normal.in_world().y, 0)],
    outputs: [taylor],
});

fn main() {}
