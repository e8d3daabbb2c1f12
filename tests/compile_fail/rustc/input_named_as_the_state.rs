use newton_euler::prelude::*;

rigid_system!(Arm {
    motion: planar,
    inputs: [elbow_angle[rad]],
    bodies: [
        upper { mass: 1.2[kg], inertia: 0.04[kg * m ^ 2], points: [tip = (0.32, 0)] },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.G),
        elbow = revolute(upper.tip, lower.G),
    ],
    drives: [servo = (3[N * m] * (elbow_angle - elbow.angle)).on(elbow)],
    outputs: [linearization],
});

// nothing is a consequence: blocks have their types
fn gain(arm: &Arm, state: &ArmState, input: &ArmInput) -> f64 {
    let found = arm.linearize(0.0, state, input);
    found.elbow_angular_by_shoulder_angle + found.a()[(3, 0)] + found.b()[(3, 0)]
}

fn main() {}
