use newton_euler::rigid_body;

rigid_body!(Mixed {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [slow = if t > 1[s] { position.in_world().x } else { velocity.in_world().x * 1[s] }],
    reactions: [wall = world(_, 0)],
});

fn main() {}
