use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    locals: [rise = acceleration.in_world().z],
    constraints: [level = rise],
    reactions: [normal = world(0, 0, _)],
});

fn main() {}
