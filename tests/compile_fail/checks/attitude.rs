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
        a = (acceleration.norm() < 1[m / s ^ 2]).given(attitude = 3, thrust = 1[N]),
        b = (acceleration.norm() < 1[m / s ^ 2]).given(attitude = turned(world(0, 0, 1)), thrust = 1[N]),
        c = (acceleration.norm() < 1[m / s ^ 2]).given(attitude = turned(world(0, 0, 0), 1), thrust = 1[N]),
    ],
});

fn main() {}
