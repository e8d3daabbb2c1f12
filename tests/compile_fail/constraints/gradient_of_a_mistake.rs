use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [wire = position.in_world().z],
    reactions: [normal = _ * wire.gradient()],
});

fn main() {}
