use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    constraints: [wire = position.in_world().y, wall = position.in_world().x],
    reactions: [normal = _ * gradient(wire), other = _ * wall.gradient],
});

fn main() {}
