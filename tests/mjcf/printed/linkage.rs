//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

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
