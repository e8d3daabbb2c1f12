use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [tip = (0.4, 0.1)[m]],
    constraints: [wire = position.in_world().y],
    reactions: [normal = (_ * -wire.gradient()).at(tip)],
});

fn main() {}
