use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: rotation,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    moments: [push = body(0, 0, 1[kg * m] * acceleration.in_body().x)],
});

fn main() {}
