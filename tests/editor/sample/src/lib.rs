//! A body and a system as users write them. `check.py` queries their words through rust-analyzer.

use newton_euler::prelude::*;

rigid_body!(Probe {
    doc: "A spinning probe with an off-axis engine.",
    motion: spatial,
    params: [offset = 2[cm], drag = 0.1[N * s ^ 2 / m ^ 2]],
    inputs: [thrust[N], wind = world(_, _, _)[m / s]],
    mass: 85[kg],
    inertia: principal(12, 12, 20)[kg * m ^ 2],
    points: [nozzle = (offset, 0, -0.6[m])],
    locals: [relative = velocity - wind],
    forces: [engine = body(0, 0, thrust).at(nozzle), brake = -drag * relative.norm() * relative],
    moments: [swirl = body(0, 0, 0.1[m] * thrust * (thrust / 400[N]).sin())],
    outputs: [energy],
});

rigid_system!(DoublePendulum {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.22, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    drives: [motor = (torque - 0.1[N * m] * elbow.angle).on(elbow)],
    outputs: [energy],
});

rigid_body!(Wheel::<T> {
    motion: pivot(hub),
    inputs: [command[rad / s]],
    params: [lag = 0.2[s]],
    states: [speed[rad / s]],
    rates: [speed = (command - speed) / lag],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [hub = (0, 0)],
    moments: [motor = 0.3[N * m * s] * (speed - angular_velocity)],
});

/// Uses what the descriptions generate.
pub fn end() -> f64 {
    let probe = Probe::default();
    let input = ProbeInput { thrust: 400.0, ..ProbeInput::default() };
    let pendulum = DoublePendulum::default();
    let state = DoublePendulumState::default();
    let angle = state.elbow.angle;
    angle + probe.acceleration(0.0, &Spatial::default(), &input).linear.z
        + pendulum.kinetic_energy(&state)
}
