use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    params: [k = acceleration.norm()],
    forces: [push = body(k * 1[kg], 0, 0)],
});

fn main() {}
