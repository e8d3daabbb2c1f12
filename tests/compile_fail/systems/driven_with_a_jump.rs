use newton_euler::prelude::*;

rigid_system!(Struck {
    motion: planar,
    params: [speed[rad / s]],
    bodies: [
        arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-0.5, 0), b = (0.5, 0)] },
        hand { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-0.5, 0), b = (0.5, 0)] },
        finger { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-0.5, 0), b = (0.5, 0)] },
        nail { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [a = (-0.5, 0)] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), arm.a).driven(if t < 2[s] { 0 } else { 0.3[rad / s] * (t - 2[s]) }),
        elbow = revolute(arm.b, hand.a).driven(speed * (t - 1[s]).max(0)),
        knuckle = revolute(hand.b, finger.a).driven(table(t, [0, 1, 2][s], [0, 0.2, 0.8])),
        tip = revolute(finger.b, nail.a),
    ],
});

fn main() {}
