use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    locals: [across = wire.gradient()],
    constraints: [wire = position.in_world().y],
    reactions: [normal = _ * across],
});

fn main() {}
