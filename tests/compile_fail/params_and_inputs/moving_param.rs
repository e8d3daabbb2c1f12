use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    params: [length[m].moving],
    constraints: [level = position.in_world().y - length],
    reactions: [floor = world(0, _)],
});

fn main() {}
