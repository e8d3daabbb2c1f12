use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    inputs: [reach[m], tilt],
    locals: [gap = position.in_world().x - reach],
    constraints: [near = gap, level = attitude - tilt],
    reactions: [wall = world(_, 0), couple = moment(_)],
});

fn main() {}
