//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

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
