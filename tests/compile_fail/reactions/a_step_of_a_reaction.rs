use newton_euler::rigid_body;

rigid_body!(Block {
    motion: planar_translation,
    mass: 2[kg],
    fields: [weight = world(0, -19.6[N])],
    constraints: [floor = position.in_world().y],
    reactions: [normal = world(0, _)],
    forces: [push = world(if normal.in_world().y > 0 { 1[N] } else { 2[N] }, 0)],
});

fn main() {}
