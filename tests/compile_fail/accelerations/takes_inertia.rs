use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    forces: [push = body(1[N], 0, 0), freed = mass * acceleration],
});

fn main() {}
