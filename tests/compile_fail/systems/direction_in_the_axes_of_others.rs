use newton_euler::rigid_system;

rigid_system!(Arm {
    bodies: [
        upper { mass: 1[kg], inertia: principal(1, 2, 2), points: [tip = (0.3, 0, 0)] },
        lower { mass: 1[kg], inertia: principal(1, 2, 2), points: [tip = (0.2, 0, 0)] },
        hand { mass: 1[kg], inertia: principal(1, 2, 2) },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), upper.G, lower.body(0, 0, 1)),
        elbow = revolute(upper.tip, lower.G, world(0, 0, 1)),
        wrist = revolute(lower.tip, hand.G, body(1, 0, 0)).turned(upper.body(0, 0, 1), 30[deg]),
    ],
});

fn main() {}
