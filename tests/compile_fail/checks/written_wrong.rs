use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    params: [pull = 9.81[m / s ^ 2], spare[N]],
    inputs: [thrust[N], push[N]],
    mass: 1.2[kg],
    inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -pull)],
    forces: [lift = body(0, 0, thrust), wind = world(push, 0, 0)],
    checks: [
        a = (mass < 2[kg]).given(),
        b = (mass < 2[kg]).given(thrust, = 2[N], push =),
        c = (mass < 2[kg]).given(thrusts = 1[N]),
        c = mass < 3[kg],
        (mass < 2[kg]),
        d,
    ],
});

fn main() {}
