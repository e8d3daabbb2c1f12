use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    inputs: [speed[m / s]],
    constraints: [pace = velocity.in_world().x - speed],
    reactions: [drive = world(_, 0)],
});

fn main() {}
