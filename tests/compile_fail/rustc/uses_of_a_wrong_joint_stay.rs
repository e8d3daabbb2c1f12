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
        elbow = revolute(upper.tpi, lower.hinge),
    ],
    outputs: [reactions],
});

fn main() {
    let state = PendulumState { shoulder: Hinge::default(), elbow: Hinge::default() };
    let reactions = Pendulum::default().reactions(0.0, &state, &());
    let _ = reactions.shoulder.force.x + reactions.elbow.moment + state.elbow.angle;
}
