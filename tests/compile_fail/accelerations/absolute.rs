use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    locals: [a = acceleration.in_body()],
    forces: [drag = body(-0.5[kg] * a.x.abs(), 0, 0)],
});

fn main() {}
