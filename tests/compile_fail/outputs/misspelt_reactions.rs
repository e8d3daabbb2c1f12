use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    reactions: [hinge = world(0, 0, _)],
    constraints: [floor = position.in_world().z],
    outputs: [reaction(hinge)],
});

fn main() {}
