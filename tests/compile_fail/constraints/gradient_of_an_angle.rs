use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    constraints: [level = attitude],
    reactions: [guide = _ * level.gradient()],
});

fn main() {}
