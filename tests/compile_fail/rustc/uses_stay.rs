use newton_euler::prelude::*;

rigid_system!(Pendulum {
    motion: planar,
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
    inputs: [load[N * m]],
    drives: [brake = load.on(elbow.angel)],
    fields: [weight = mass * world(0, -9.81)],
    outputs: [energy, momentum, reactions],
});

fn main() {
    let pendulum = Pendulum::default();
    let input = PendulumInput { load: 1.0 };
    let state = PendulumState {
        shoulder: Hinge { angle: 0.9, angular_velocity: 2.1 },
        elbow: Hinge { angle: -1.3, angular_velocity: -5.4 },
    };
    let acceleration = pendulum.acceleration(0.0, &state, &input);
    let reactions: PendulumReactions = pendulum.reactions(0.0, &state, &input);
    let _ = acceleration.shoulder + acceleration.elbow + reactions.elbow.force.x;
    let _ = pendulum.kinetic_energy(&state) + pendulum.linear_momentum(&state).x;
    let _ = pendulum.integrate(&state).input(input).to(1.0);
}
