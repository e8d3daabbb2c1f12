use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    inputs: [height[m].moving],
    constraints: [level = position.in_world().y - height_rate * 1[s]],
    reactions: [floor = world(0, _)],
});

fn main() {}
