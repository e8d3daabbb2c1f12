use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    points: [p = G + 0.1[s ^ 2] * acceleration],
    forces: [push = body(1[N], 0, 0).at(p)],
});

fn main() {}
