use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    locals: [a = acceleration.in_body().x],
    forces: [drag = body(if a > 0 { -1[kg] * a } else { -2[kg] * a }, 0, 0)],
});

fn main() {}
