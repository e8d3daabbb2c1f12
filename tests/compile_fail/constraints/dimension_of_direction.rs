use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    constraints: [rope = position.norm() - 2[m]],
    reactions: [tension = _ * position],
});

fn main() {}
