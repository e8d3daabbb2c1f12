use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    params: [mu = 0.3],
    locals: [pressed = normal.in_world().y],
    constraints: [floor = position.in_world().y],
    reactions: [normal = world(0, _)],
    forces: [friction = world(-mu * pressed, 0)],
});

fn main() {}
