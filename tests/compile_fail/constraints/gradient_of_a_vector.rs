use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [pin = position.in_world()],
    reactions: [across = _ * pin.gradient(), along = _ * pin.x.gradient()],
});

fn main() {}
