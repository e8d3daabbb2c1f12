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
        hover = (thrust < 1[N]).given(thrust = 0[N], thrust = 2[N]),
    ],
});

rigid_body!(Kite {
    motion: planar,
    params: [pull = 1[N], wind = 2[N]],
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    forces: [line = world(pull, wind)],
    checks: [
        flies = (angular_acceleration > -1[rad / s ^ 2]).given(pull = 1[N]).given(wind = 2[N]),
    ],
});

fn main() {}
