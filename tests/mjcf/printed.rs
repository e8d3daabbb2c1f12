//! What the descriptions with files amount to, as `describe` prints it.

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

rigid_system!(QuadrupedPrinted {
    inputs: [thigh_1_motor[N * m], motor_2[N * m]],
    bodies: [
        trunk {
            inertia: compose([
                cuboid(2 * 0.25, 2 * 0.1, 2 * 0.06)
                    .turned(body(0, 0, 1), 10[deg])
                    .turned(body(0, 1, 0), 5[deg])
                    .turned(body(1, 0, 0), -3[deg])
                    .mass(800 * 8 * 0.25 * 0.1 * 0.06)
                    .at((0.01, 0, 0.02)),
                cylinder(
                    0.03,
                    2 * (((0.2 - 0.25).powi(2) + (0.02 - -0.03).powi(2) + (0.05 - 0.1).powi(2))
                        .sqrt()
                        / 2)
                )
                .turned(
                    body(-(0.02 - -0.03), 0.2 - 0.25, 0),
                    ((0.2 - 0.25).powi(2) + (0.02 - -0.03).powi(2))
                        .sqrt()
                        .atan2(0.05 - 0.1)
                )
                .mass(
                    800 * 2
                        * PI
                        * 0.03.powi(2)
                        * (((0.2 - 0.25).powi(2) + (0.02 - -0.03).powi(2) + (0.05 - 0.1).powi(2))
                            .sqrt()
                            / 2)
                )
                .at(((0.2 + 0.25) / 2, (0.02 + -0.03) / 2, (0.05 + 0.1) / 2))
            ]),
            points: [hip_1 = (0.2, 0.12, 0), rear_frame = (-0.2, -0.12, 0)],
        },
        front_left_after_hip_1 {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
        front_left {
            inertia: compose([principal(
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt() / 2)
                        + 4 / 3 * 0.02)
                    * ((1 - 2 * 0.02
                        / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02))
                        * (0.02.powi(2) / 4
                            + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                                / 3)
                        + 2 * 0.02
                            / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * (2 / 5 * 0.02.powi(2)
                                + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                    .sqrt()
                                    / 2)
                                .powi(2)
                                + 3 / 4
                                    * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                        .sqrt()
                                        / 2)
                                    * 0.02)),
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt() / 2)
                        + 4 / 3 * 0.02)
                    * ((1 - 2 * 0.02
                        / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02))
                        * (0.02.powi(2) / 4
                            + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                                / 3)
                        + 2 * 0.02
                            / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * (2 / 5 * 0.02.powi(2)
                                + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                    .sqrt()
                                    / 2)
                                .powi(2)
                                + 3 / 4
                                    * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                        .sqrt()
                                        / 2)
                                    * 0.02)),
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt() / 2)
                        + 4 / 3 * 0.02)
                    * 0.02.powi(2)
                    * ((1 - 2 * 0.02
                        / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02))
                        / 2
                        + 2 * 0.02
                            / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * 2
                            / 5)
            )
            .mass(
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2)).sqrt() / 2)
                        + 4 / 3 * 0.02)
            )
            .at(((0 + 0) / 2, (0 + 0) / 2, (0 + -0.2) / 2))]),
            points: [origin = (0, 0, 0), knee_1 = (0, 0, -0.2)],
        },
        shin_1 {
            inertia: compose([
                principal(
                    800 * PI
                        * 0.02.powi(2)
                        * (2 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                            .sqrt()
                            / 2)
                            + 4 / 3 * 0.02)
                        * ((1 - 2 * 0.02
                            / (3 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02))
                            * (0.02.powi(2) / 4
                                + (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                    .sqrt()
                                    / 2)
                                .powi(2)
                                    / 3)
                            + 2 * 0.02
                                / (3 * (((0 - 0.03).powi(2)
                                    + (0 - 0).powi(2)
                                    + (0 - -0.2).powi(2))
                                .sqrt()
                                    / 2)
                                    + 2 * 0.02)
                                * (2 / 5 * 0.02.powi(2)
                                    + (((0 - 0.03).powi(2)
                                        + (0 - 0).powi(2)
                                        + (0 - -0.2).powi(2))
                                    .sqrt()
                                        / 2)
                                    .powi(2)
                                    + 3 / 4
                                        * (((0 - 0.03).powi(2)
                                            + (0 - 0).powi(2)
                                            + (0 - -0.2).powi(2))
                                        .sqrt()
                                            / 2)
                                        * 0.02)),
                    800 * PI
                        * 0.02.powi(2)
                        * (2 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                            .sqrt()
                            / 2)
                            + 4 / 3 * 0.02)
                        * ((1 - 2 * 0.02
                            / (3 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02))
                            * (0.02.powi(2) / 4
                                + (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                    .sqrt()
                                    / 2)
                                .powi(2)
                                    / 3)
                            + 2 * 0.02
                                / (3 * (((0 - 0.03).powi(2)
                                    + (0 - 0).powi(2)
                                    + (0 - -0.2).powi(2))
                                .sqrt()
                                    / 2)
                                    + 2 * 0.02)
                                * (2 / 5 * 0.02.powi(2)
                                    + (((0 - 0.03).powi(2)
                                        + (0 - 0).powi(2)
                                        + (0 - -0.2).powi(2))
                                    .sqrt()
                                        / 2)
                                    .powi(2)
                                    + 3 / 4
                                        * (((0 - 0.03).powi(2)
                                            + (0 - 0).powi(2)
                                            + (0 - -0.2).powi(2))
                                        .sqrt()
                                            / 2)
                                        * 0.02)),
                    800 * PI
                        * 0.02.powi(2)
                        * (2 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                            .sqrt()
                            / 2)
                            + 4 / 3 * 0.02)
                        * 0.02.powi(2)
                        * ((1 - 2 * 0.02
                            / (3 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02))
                            / 2
                            + 2 * 0.02
                                / (3 * (((0 - 0.03).powi(2)
                                    + (0 - 0).powi(2)
                                    + (0 - -0.2).powi(2))
                                .sqrt()
                                    / 2)
                                    + 2 * 0.02)
                                * 2
                                / 5)
                )
                .turned(
                    body(-(0 - 0), 0 - 0.03, 0),
                    ((0 - 0.03).powi(2) + (0 - 0).powi(2))
                        .sqrt()
                        .atan2(0 - -0.2)
                )
                .mass(
                    800 * PI
                        * 0.02.powi(2)
                        * (2 * (((0 - 0.03).powi(2) + (0 - 0).powi(2) + (0 - -0.2).powi(2))
                            .sqrt()
                            / 2)
                            + 4 / 3 * 0.02)
                )
                .at(((0 + 0.03) / 2, (0 + 0) / 2, (0 + -0.2) / 2)),
                sphere(0.025).mass(0.05).at((0.03, 0, -0.2))
            ]),
            points: [origin = (0, 0, 0)],
        },
        rear_frame {
            mass: 0[kg],
            points: [origin = (0, 0, 0), thigh_2 = (0, 0.01, 0.02)],
        },
        rear {
            inertia: compose([principal(
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0.01 - -0.03).powi(2) + (0 - 0.02).powi(2) + (0 - -0.2).powi(2))
                        .sqrt()
                        / 2)
                        + 4 / 3 * 0.02)
                    * ((1 - 2 * 0.02
                        / (3 * (((0.01 - -0.03).powi(2)
                            + (0 - 0.02).powi(2)
                            + (0 - -0.2).powi(2))
                        .sqrt()
                            / 2)
                            + 2 * 0.02))
                        * (0.02.powi(2) / 4
                            + (((0.01 - -0.03).powi(2)
                                + (0 - 0.02).powi(2)
                                + (0 - -0.2).powi(2))
                            .sqrt()
                                / 2)
                            .powi(2)
                                / 3)
                        + 2 * 0.02
                            / (3 * (((0.01 - -0.03).powi(2)
                                + (0 - 0.02).powi(2)
                                + (0 - -0.2).powi(2))
                            .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * (2 / 5 * 0.02.powi(2)
                                + (((0.01 - -0.03).powi(2)
                                    + (0 - 0.02).powi(2)
                                    + (0 - -0.2).powi(2))
                                .sqrt()
                                    / 2)
                                .powi(2)
                                + 3 / 4
                                    * (((0.01 - -0.03).powi(2)
                                        + (0 - 0.02).powi(2)
                                        + (0 - -0.2).powi(2))
                                    .sqrt()
                                        / 2)
                                    * 0.02)),
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0.01 - -0.03).powi(2) + (0 - 0.02).powi(2) + (0 - -0.2).powi(2))
                        .sqrt()
                        / 2)
                        + 4 / 3 * 0.02)
                    * ((1 - 2 * 0.02
                        / (3 * (((0.01 - -0.03).powi(2)
                            + (0 - 0.02).powi(2)
                            + (0 - -0.2).powi(2))
                        .sqrt()
                            / 2)
                            + 2 * 0.02))
                        * (0.02.powi(2) / 4
                            + (((0.01 - -0.03).powi(2)
                                + (0 - 0.02).powi(2)
                                + (0 - -0.2).powi(2))
                            .sqrt()
                                / 2)
                            .powi(2)
                                / 3)
                        + 2 * 0.02
                            / (3 * (((0.01 - -0.03).powi(2)
                                + (0 - 0.02).powi(2)
                                + (0 - -0.2).powi(2))
                            .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * (2 / 5 * 0.02.powi(2)
                                + (((0.01 - -0.03).powi(2)
                                    + (0 - 0.02).powi(2)
                                    + (0 - -0.2).powi(2))
                                .sqrt()
                                    / 2)
                                .powi(2)
                                + 3 / 4
                                    * (((0.01 - -0.03).powi(2)
                                        + (0 - 0.02).powi(2)
                                        + (0 - -0.2).powi(2))
                                    .sqrt()
                                        / 2)
                                    * 0.02)),
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0.01 - -0.03).powi(2) + (0 - 0.02).powi(2) + (0 - -0.2).powi(2))
                        .sqrt()
                        / 2)
                        + 4 / 3 * 0.02)
                    * 0.02.powi(2)
                    * ((1 - 2 * 0.02
                        / (3 * (((0.01 - -0.03).powi(2)
                            + (0 - 0.02).powi(2)
                            + (0 - -0.2).powi(2))
                        .sqrt()
                            / 2)
                            + 2 * 0.02))
                        / 2
                        + 2 * 0.02
                            / (3 * (((0.01 - -0.03).powi(2)
                                + (0 - 0.02).powi(2)
                                + (0 - -0.2).powi(2))
                            .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * 2
                            / 5)
            )
            .turned(
                body(-(0 - 0.02), 0.01 - -0.03, 0),
                ((0.01 - -0.03).powi(2) + (0 - 0.02).powi(2))
                    .sqrt()
                    .atan2(0 - -0.2)
            )
            .mass(
                800 * PI
                    * 0.02.powi(2)
                    * (2 * (((0.01 - -0.03).powi(2) + (0 - 0.02).powi(2) + (0 - -0.2).powi(2))
                        .sqrt()
                        / 2)
                        + 4 / 3 * 0.02)
            )
            .at(((0.01 + -0.03) / 2, (0 + 0.02) / 2, (0 + -0.2) / 2))]),
            points: [thigh_2 = (0, 0.01, 0.02), mount = (0, 0, -0.2)],
        },
        mount {
            mass: 0[kg],
            points: [origin = (0, 0, 0), sensor = (0.01, 0.02, 0.03)],
        },
        sensor {
            inertia: compose([cuboid(2 * 0.01, 2 * 0.02, 2 * 0.03)
                .mass(800 * 8 * 0.01 * 0.02 * 0.03)
                .at((0, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        root = free(trunk),
        hip_1 = revolute(trunk.hip_1, front_left_after_hip_1.origin, body(1, 0, 0))
            .turned(body(1, 0, 0), 5[deg])
            .turned(body(0, 1, 0), 10[deg]),
        thigh_1 = revolute(
            front_left_after_hip_1.origin,
            front_left.origin,
            body(0, 1, 0)
        ),
        knee_1 = revolute(front_left.knee_1, shin_1.origin, body(0, 1, 0))
            .turned(body(0, 1, 0), -15[deg]),
        rear_turned = weld(trunk.rear_frame, rear_frame.origin).turned(body(0, 0, 1), -5[deg]),
        thigh_2 = revolute(rear_frame.thigh_2, rear.thigh_2, body(0, 1, 0)),
        mount_to_rear = weld(rear.mount, mount.origin).turned(body(0, 0, 1), 30[deg]),
        sensor_to_mount = weld(mount.sensor, sensor.origin).turned(body(-1, 0, 0), 90[deg]),
    ],
    fields: [gravity = mass * world(0, 0, -9.81)],
    potentials: [
        hip_1_spring = 2 / 2 * (hip_1.angle - -20[deg]).powi(2),
        thigh_1_spring = 2 / 2 * (thigh_1.angle - -20[deg]).powi(2),
        knee_1_spring = 2 / 2 * (knee_1.angle - -20[deg]).powi(2),
        thigh_2_spring = 2 / 2 * (thigh_2.angle - -20[deg]).powi(2),
    ],
    drives: [
        hip_1_damping = (-0.2 * hip_1.angular_velocity).on(hip_1),
        thigh_1_damping = (-0.2 * thigh_1.angular_velocity).on(thigh_1),
        knee_1_damping = (-0.2 * knee_1.angular_velocity).on(knee_1),
        thigh_2_damping = (-0.2 * thigh_2.angular_velocity).on(thigh_2),
        thigh_1_motor_on_thigh_1 = (2 * thigh_1_motor).on(thigh_1),
        motor_2_on_knee_1 = motor_2.on(knee_1),
    ],
});

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

rigid_system!(LinkagePrinted {
    bodies: [
        crank {
            inertia: compose([principal(
                0.5 * ((1 - 2 * 0.02
                    / (3 * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                        + 2 * 0.02))
                    * (0.02.powi(2) / 4
                        + (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.02
                        / (3 * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2)
                            + (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.02)),
                0.5 * ((1 - 2 * 0.02
                    / (3 * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                        + 2 * 0.02))
                    * (0.02.powi(2) / 4
                        + (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.02
                        / (3 * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2)
                            + (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.02)),
                0.5 * 0.02.powi(2)
                    * ((1 - 2 * 0.02
                        / (3 * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02))
                        / 2
                        + 2 * 0.02
                            / (3 * (((0 - 0.2).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * 2
                            / 5)
            )
            .turned(body(0, 1, 0), 90[deg])
            .mass(0.5)
            .at(((0 + 0.2) / 2, (0 + 0) / 2, (0 + 0) / 2))]),
            points: [origin = (0, 0, 0), pin = (0.2, 0, 0)],
        },
        rod_after_pin {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
        rod {
            inertia: compose([principal(
                0.8 * ((1 - 2 * 0.02
                    / (3 * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                        + 2 * 0.02))
                    * (0.02.powi(2) / 4
                        + (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.02
                        / (3 * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2)
                            + (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.02)),
                0.8 * ((1 - 2 * 0.02
                    / (3 * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                        + 2 * 0.02))
                    * (0.02.powi(2) / 4
                        + (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.02
                        / (3 * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2)
                            + (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.02)),
                0.8 * 0.02.powi(2)
                    * ((1 - 2 * 0.02
                        / (3 * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02))
                        / 2
                        + 2 * 0.02
                            / (3 * (((0 - 0.5).powi(2) + (0 - 0).powi(2) + (0 - 0).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * 2
                            / 5)
            )
            .turned(body(0, 1, 0), 90[deg])
            .mass(0.8)
            .at(((0 + 0.5) / 2, (0 + 0) / 2, (0 + 0) / 2))]),
            points: [
                origin = (0, 0, 0),
                close = (0.44999999999999973, 0.02, 0.09999999999999995),
            ],
        },
        rocker_frame {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
        rocker {
            inertia: compose([cuboid(2 * 0.02, 2 * 0.02, 2 * 0.2)
                .mass(0.9)
                .at((0, 0, 0.15))]),
            points: [origin = (0, 0, 0), tip = (0, 0, 0.3)],
        },
        tip {
            inertia: compose([sphere(0.02).mass(0.1).at((0, 0, 0))]),
            points: [
                origin = (0, 0, 0),
                close = (
                    -0.10144930179943397,
                    -0.010045373778142495,
                    -0.15066381217040622
                ),
                closing_2 = (
                    -0.14481473881275786,
                    0.029355400846913276,
                    0.17766824456280306
                ),
            ],
        },
        glued {
            inertia: compose([sphere(0.03).mass(0.2).at((0.01, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        crank_joint =
            revolute(world(0, 0, 1), crank.origin, body(0, 1, 0)).turned(body(0, 1, 0), 0.5),
        pin = revolute(crank.pin, rod_after_pin.origin, body(0, 1, 0)).turned(body(0, 1, 0), -0.9),
        twist = revolute(rod_after_pin.origin, rod.origin, body(1, 0, 0)),
        rocker_turned = weld(world(0.6, 0.05, 1), rocker_frame.origin)
            .turned(body(0, 1, 0), 0.3)
            .turned(body(0, 0, 1), 0.2),
        swing = spherical(rocker_frame.origin, rocker.origin),
        tip_to_rocker = weld(rocker.tip, tip.origin),
        away = free(glued),
        close = spherical(rod.close, tip.close),
        closing_2 = weld(tip.closing_2, glued.origin)
            .turned(body(0, 0, 1), 0.028624832524607232)
            .turned(body(0, 1, 0), -0.020331705521169332)
            .turned(body(1, 0, 0), 0.09334793228413131),
    ],
    fields: [gravity = mass * world(0, 0, -9.81)],
});
