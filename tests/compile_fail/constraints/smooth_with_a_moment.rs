use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    points: [tip = (1, 0)[m]],
    constraints: [wire = tip.position().in_world().y],
    reactions: [normal = (_ * wire.gradient()).at(tip)],
});

fn main() {}
