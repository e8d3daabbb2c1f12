use newton_euler::rigid_system;

rigid_system!(Arm {
    bodies: [
        upper { mass: 1[kg], inertia: principal(1, 2, 2), points: [tip = (0.3, 0, 0)] },
        lower { mass: 1[kg], inertia: principal(1, 2, 2), points: [tip = (0.2, 0, 0)] },
    ],
    joints: [
        shoulder = spherical(world(0, 0, 0), upper.G),
        elbow = spherical(upper.tip, lower.G),
    ],
    checks: [
        bent = (lower.tip.position().in_world().z < 1[m]).given(
            shoulder.attitude = turned(world(1, 0, 0), 90[deg]),
            elbow.attitude = turned(world(0, 0, 1), 90[deg]),
        ),
        zero = (lower.tip.position().in_world().z < 1[m]).given(
            shoulder.attitude = turned(lower.body(1, 0, 0), 90[deg]),
            elbow.attitude = turned(upper.body(0, 0, 1) - upper.body(0, 0, 1), 90[deg]),
        ),
    ],
});

fn main() {}
