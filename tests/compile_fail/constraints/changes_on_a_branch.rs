use newton_euler::rigid_body;

rigid_body!(Drifting {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [floor = if position.in_world().x > 1[m] { t * 1[m / s] } else { position.in_world().y }],
    reactions: [ground = world(0, _)],
});

fn main() {}
