use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    constraints: [level = acceleration.in_world().z],
    reactions: [normal = world(0, 0, _)],
});

fn main() {}
