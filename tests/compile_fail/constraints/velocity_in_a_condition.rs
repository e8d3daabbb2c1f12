use newton_euler::rigid_body;

rigid_body!(Block {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [floor = if velocity.in_world().x > 1[m / s] { position.in_world().y } else { 0[m] }],
    reactions: [ground = world(0, _)],
});

fn main() {}
