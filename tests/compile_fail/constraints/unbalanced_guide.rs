use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    points: [shoe = (0.1, 0.2)],
    constraints: [rail = position.in_world().y],
    reactions: [guide = world(0, _).at(shoe)],
});

fn main() {}
