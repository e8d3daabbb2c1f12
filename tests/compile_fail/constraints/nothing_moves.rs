use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    params: [length = 2[m]],
    inputs: [height[m].moving],
    constraints: [level = height - length * (t / 1[s]).sin()],
    reactions: [push = world(0, _)],
});

fn main() {}
