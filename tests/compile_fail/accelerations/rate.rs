use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    states: [measured[m / s ^ 2]],
    rates: [measured = (acceleration.in_body().x - measured) / 0.1[s]],
    forces: [held = body(-2[kg] * measured, 0, 0)],
});

fn main() {}
