//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(ArmPrinted {
    inputs: [pan_motor[N * m], slip_motor[N]],
    bodies: [
        column {
            inertia: compose([principal(0.021, 0.0215, 0.009)
                .turned(
                    body(0.1, -0.3, 0.2),
                    2 * (0.1.powi(2) + (-0.3).powi(2) + 0.2.powi(2))
                        .sqrt()
                        .atan2(0.9)
                )
                .mass(3.2)
                .at((0.01, 0.02, 0.12))]),
            points: [origin = (0, 0, 0), upper_frame = (0, 0.06, 0.2)],
        },
        upper_frame {
            mass: 0[kg],
            points: [origin = (0, 0, 0), lift = (0.02, -0.01, 0.03)],
        },
        upper_after_lift {
            mass: 0[kg],
            points: [lift = (0.02, -0.01, 0.03), slip = (0.1, 0, 0)],
        },
        upper {
            inertia: compose([tensor {
                xx: 0.004,
                yy: 0.041,
                zz: 0.042,
                xy: 0.0006,
                zx: -0.0003,
                yz: 0.0002
            }
            .mass(2.4)
            .at((0.21, 0.01, 0))]),
            points: [
                origin = (0, 0, 0),
                slip = origin + body(0.1, 0, 0) - --0.05 * body(1, 2, 2).normalize(),
                elbow = (0.4, -0.02, 0.01),
            ],
        },
        fore {
            inertia: compose([
                principal(
                    1.1 * ((1 - 2 * 0.03
                        / (3 * (((0 - 0.3).powi(2) + (0 - 0.05).powi(2) + (0 - -0.04).powi(2))
                            .sqrt()
                            / 2)
                            + 2 * 0.03))
                        * (0.03.powi(2) / 4
                            + (((0 - 0.3).powi(2) + (0 - 0.05).powi(2) + (0 - -0.04).powi(2))
                                .sqrt()
                                / 2)
                            .powi(2)
                                / 3)
                        + 2 * 0.03
                            / (3 * (((0 - 0.3).powi(2)
                                + (0 - 0.05).powi(2)
                                + (0 - -0.04).powi(2))
                            .sqrt()
                                / 2)
                                + 2 * 0.03)
                            * (2 / 5 * 0.03.powi(2)
                                + (((0 - 0.3).powi(2)
                                    + (0 - 0.05).powi(2)
                                    + (0 - -0.04).powi(2))
                                .sqrt()
                                    / 2)
                                .powi(2)
                                + 3 / 4
                                    * (((0 - 0.3).powi(2)
                                        + (0 - 0.05).powi(2)
                                        + (0 - -0.04).powi(2))
                                    .sqrt()
                                        / 2)
                                    * 0.03)),
                    1.1 * ((1 - 2 * 0.03
                        / (3 * (((0 - 0.3).powi(2) + (0 - 0.05).powi(2) + (0 - -0.04).powi(2))
                            .sqrt()
                            / 2)
                            + 2 * 0.03))
                        * (0.03.powi(2) / 4
                            + (((0 - 0.3).powi(2) + (0 - 0.05).powi(2) + (0 - -0.04).powi(2))
                                .sqrt()
                                / 2)
                            .powi(2)
                                / 3)
                        + 2 * 0.03
                            / (3 * (((0 - 0.3).powi(2)
                                + (0 - 0.05).powi(2)
                                + (0 - -0.04).powi(2))
                            .sqrt()
                                / 2)
                                + 2 * 0.03)
                            * (2 / 5 * 0.03.powi(2)
                                + (((0 - 0.3).powi(2)
                                    + (0 - 0.05).powi(2)
                                    + (0 - -0.04).powi(2))
                                .sqrt()
                                    / 2)
                                .powi(2)
                                + 3 / 4
                                    * (((0 - 0.3).powi(2)
                                        + (0 - 0.05).powi(2)
                                        + (0 - -0.04).powi(2))
                                    .sqrt()
                                        / 2)
                                    * 0.03)),
                    1.1 * 0.03.powi(2)
                        * ((1 - 2 * 0.03
                            / (3 * (((0 - 0.3).powi(2)
                                + (0 - 0.05).powi(2)
                                + (0 - -0.04).powi(2))
                            .sqrt()
                                / 2)
                                + 2 * 0.03))
                            / 2
                            + 2 * 0.03
                                / (3 * (((0 - 0.3).powi(2)
                                    + (0 - 0.05).powi(2)
                                    + (0 - -0.04).powi(2))
                                .sqrt()
                                    / 2)
                                    + 2 * 0.03)
                                * 2
                                / 5)
                )
                .turned(
                    body(-(0 - 0.05), 0 - 0.3, 0),
                    ((0 - 0.3).powi(2) + (0 - 0.05).powi(2))
                        .sqrt()
                        .atan2(0 - -0.04)
                )
                .mass(1.1)
                .at(((0 + 0.3) / 2, (0 + 0.05) / 2, (0 + -0.04) / 2)),
                cuboid(2 * 0.04, 2 * 0.02, 2 * 0.03)
                    .turned(
                        body(0.4, -0.5, 0.6),
                        2 * (0.4.powi(2) + (-0.5).powi(2) + 0.6.powi(2))
                            .sqrt()
                            .atan2(0.3)
                    )
                    .mass(1000 * 8 * 0.04 * 0.02 * 0.03)
                    .at((0.1, 0.02, 0)),
                ellipsoid(0.05, 0.03, 0.02)
                    .turned(body(2, 1, 0), (1.powi(2) + (-2).powi(2)).sqrt().atan2(0.5))
                    .mass(700 * 4 / 3 * PI * 0.05 * 0.03 * 0.02)
                    .at((0, 0, 0.05))
            ]),
            points: [origin = (0, 0, 0), roll = (0.35, 0, 0)],
        },
        hand_after_roll {
            mass: 0[kg],
            points: [origin = (0, 0, 0), bend = (0.02, 0, 0)],
        },
        hand {
            inertia: compose([
                cylinder(0.02, 2 * 0.05)
                    .mass(1200 * 2 * PI * 0.02.powi(2) * 0.05)
                    .at((0.05, 0.01, 0)),
                sphere(0.03).mass(0.3).at((0.1, 0, 0.02))
            ]),
            points: [bend = (0.02, 0, 0)],
        },
    ],
    joints: [
        pan = revolute(world(0.1, -0.2, 0.3), column.origin, body(0, 0, 1))
            .turned(body(1, 0, 0), 0.2)
            .turned(body(0, 1, 0), -0.1)
            .turned(body(0, 0, 1), 0.4),
        upper_turned = weld(column.upper_frame, upper_frame.origin).turned(
            body(0.5, 0.5, 0.5),
            2 * (0.5.powi(2) + 0.5.powi(2) + 0.5.powi(2)).sqrt().atan2(0.5)
        ),
        lift = revolute(upper_frame.lift, upper_after_lift.lift, body(0.1, 1, -0.2))
            .turned(body(0.1, 1, -0.2), -0.3),
        slip = prismatic(upper_after_lift.slip, upper.slip, body(1, 2, 2)),
        elbow = revolute(upper.elbow, fore.origin, body(0, 1, 0)).turned(body(1, 2, -1), 0.8),
        roll = revolute(fore.roll, hand_after_roll.origin, body(1, 0, 0))
            .turned(body(0, 0, 1), 0.2.atan2(1))
            .turned(body(0, 1, 0), -0.1.atan2((1.powi(2) + 0.2.powi(2)).sqrt()))
            .turned(
                body(1, 0, 0),
                ((1.powi(2) + 0.2.powi(2)).sqrt().powi(2) * -0.4 - 0.1 * (0.3 * 1 + 1 * 0.2))
                    .atan2((1 * 1 - 0.3 * 0.2) * (1.powi(2) + 0.2.powi(2) + 0.1.powi(2)).sqrt())
            ),
        bend = revolute(hand_after_roll.bend, hand.bend, body(0, 1, 0)),
    ],
    fields: [gravity = mass * world(0.3, 0, -9.7)],
    potentials: [
        lift_spring = 4.5 / 2 * (lift.angle - 0.7).powi(2),
        slip_spring = 120 / 2 * (slip.position - 0.02).powi(2),
    ],
    drives: [
        pan_damping = (-0.1 * pan.angular_velocity).on(pan),
        lift_damping = (-0.1 * lift.angular_velocity).on(lift),
        slip_damping = (-3 * slip.velocity).on(slip),
        elbow_damping = (-0.1 * elbow.angular_velocity).on(elbow),
        roll_damping = (-0.02 * roll.angular_velocity).on(roll),
        bend_damping = (-0.02 * bend.angular_velocity).on(bend),
        pan_motor_on_pan = (3 * pan_motor).on(pan),
        slip_motor_on_slip = (-20 * slip_motor).on(slip),
    ],
    outputs: [energy],
});
