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
        heavy = mass > 1[N],
        hover = (acceleration.norm() < 1[m / s ^ 2]).given(thrust = 3[kg], push = world(1, 0, 0)[N]),
    ],
});

fn main() {}
