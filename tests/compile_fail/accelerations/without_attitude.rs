use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: translation,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    forces: [push = world(1[kg * m] * angular_acceleration.in_world().x, 0, 0)],
});

fn main() {}
