use newton_euler::prelude::*;

rigid_system!(Arm {
    bodies: [
        upper {
            mass: 1[kg],
            inertia: principal(1, 2, 2.5)[kg * m ^ 2],
            points: [tip_x = (1, 0, 0)[m]],
        },
        upper_tip {
            mass: 1[kg],
            inertia: principal(1, 2, 2.5)[kg * m ^ 2],
            points: [x = (0, 1, 0)[m]],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), upper.G, body(0, 0, 1)),
        elbow = revolute(upper.tip_x, upper_tip.G, body(1, 0, 0)),
    ],
    outputs: [jacobian(upper.tip_x, upper_tip.x)],
});

fn main() {}
