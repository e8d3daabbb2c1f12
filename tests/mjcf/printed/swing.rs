//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(SwingPrinted {
    bodies: [
        arm_frame {
            mass: 0[kg],
            points: [origin = (0, 0, 0), ball = (0.01, 0.02, 0.3)],
        },
        arm {
            inertia: compose([principal(0.02, 0.03, 0.015).mass(1.3).at((0.02, 0, -0.1))]),
            points: [ball = (0.01, 0.02, 0.3), x = (0, 0, -0.5)],
        },
        cup_after_x {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
        cup_after_y {
            mass: 0[kg],
            points: [origin = (0, 0, 0), turn = (0.1, 0, 0)],
        },
        cup_after_turn {
            mass: 0[kg],
            points: [origin = (0, 0, 0), turn = (0.1, 0, 0)],
        },
        cup {
            inertia: compose([
                ellipsoid(
                    0.05,
                    0.05,
                    ((0.05 - 0.02).powi(2) + (0 - 0.1).powi(2) + (0 - 0.2).powi(2)).sqrt() / 2
                )
                .turned(
                    body(-(0 - 0.1), 0.05 - 0.02, 0),
                    ((0.05 - 0.02).powi(2) + (0 - 0.1).powi(2))
                        .sqrt()
                        .atan2(0 - 0.2)
                )
                .mass(
                    500 * 4 / 3
                        * PI
                        * 0.05
                        * 0.05
                        * (((0.05 - 0.02).powi(2) + (0 - 0.1).powi(2) + (0 - 0.2).powi(2)).sqrt()
                            / 2)
                )
                .at(((0.05 + 0.02) / 2, (0 + 0.1) / 2, (0 + 0.2) / 2)),
                cuboid(
                    2 * 0.05,
                    2 * 0.05,
                    2 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                )
                .turned(body(0, 1, 0), 90[deg])
                .mass(
                    500 * 8
                        * 0.05
                        * 0.05
                        * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                )
                .at(((0 + 0.1) / 2, (0 + 0) / 2, (0 + 0) / 2))
            ]),
            points: [
                origin = (0, 0, 0),
                held = origin + body(0, 0, 0) - (50[mm] - 0.02) * body(1, 1, 0).normalize(),
                body_3_joint = (0.1, 0.2, 0.3),
            ],
        },
        body_3 {
            inertia: compose([principal(
                0.4 * ((1 - 2 * 0.02 / (3 * 0.1 + 2 * 0.02))
                    * (0.02.powi(2) / 4 + 0.1.powi(2) / 3)
                    + 2 * 0.02 / (3 * 0.1 + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2) + 0.1.powi(2) + 3 / 4 * 0.1 * 0.02)),
                0.4 * ((1 - 2 * 0.02 / (3 * 0.1 + 2 * 0.02))
                    * (0.02.powi(2) / 4 + 0.1.powi(2) / 3)
                    + 2 * 0.02 / (3 * 0.1 + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2) + 0.1.powi(2) + 3 / 4 * 0.1 * 0.02)),
                0.4 * 0.02.powi(2)
                    * ((1 - 2 * 0.02 / (3 * 0.1 + 2 * 0.02)) / 2
                        + 2 * 0.02 / (3 * 0.1 + 2 * 0.02) * 2 / 5)
            )
            .mass(0.4)
            .at((0, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        arm_turned = weld(world(0, 0.1, 2), arm_frame.origin)
            .turned(body(1, 0, 0), 20[deg])
            .turned(body(0, 1, 0), -30[deg])
            .turned(body(0, 0, 1), 40[deg]),
        ball = spherical(arm_frame.ball, arm.ball),
        x = prismatic(arm.x, cup_after_x.origin, body(1, 0, 0))
            .turned(body(0, 0.6, 0), 2 * 0.6.atan2(0.8)),
        y = prismatic(cup_after_x.origin, cup_after_y.origin, body(0, 1, 0)),
        turn = revolute(cup_after_y.turn, cup_after_turn.turn, body(0, 0, 1)),
        held = weld(cup_after_turn.origin, cup.held),
        body_3_joint = revolute(cup.body_3_joint, body_3.origin, body(0, 1, 1))
            .turned(body(0, 1, 1), -10[deg]),
    ],
    fields: [gravity = mass * world(0, 0, -9.81)],
    potentials: [y_spring = 30 / 2 * (y.position - 0).powi(2)],
    drives: [ball_damping = (-0.3 * ball.angular_velocity).on(ball)],
});
