//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(ClassesPrinted {
    inputs: [
        law,
        servo,
        loose,
        brake,
        tuned,
        strong,
        firm,
        slack,
        paced[rad / s],
        inner,
        same,
        plain,
        bare[N * m],
        nearest,
        beside,
        reset[rad / s],
        braked,
    ],
    bodies: [
        post {
            inertia: compose([cuboid(2 * 0.1, 2 * 0.08, 2 * 0.06)
                .turned(body(0, 0, 0.3), 2 * 0.3.atan2(1))
                .mass(400 * 8 * 0.1 * 0.08 * 0.06)
                .at((0.1, 0, 0))]),
            points: [origin = (0, 0, 0), roll = (0.4, 0, 0.1)],
        },
        boom {
            inertia: compose([cuboid(2 * 0.2, 2 * 0.08, 2 * 0.06)
                .turned(body(0, 1, 1), 0.4)
                .mass(400 * 8 * 0.2 * 0.08 * 0.06)
                .at((0, 0, 0))]),
            points: [
                origin = (0, 0, 0),
                grip = (0.1, 0.2, -0.3),
                pin = (0.29999999999999993, 0.1, 0),
            ],
        },
        rod_frame {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
        rod {
            inertia: compose([principal(0.02, 0.03, 0.01).mass(0.9).at((0, 0, 0.15))]),
            points: [
                origin = (0, 0, 0),
                pin = (
                    -0.14245921720047772,
                    -0.07315597151687277,
                    0.06598162824642671
                ),
            ],
        },
        load {
            inertia: compose([cuboid(2 * 0.1, 2 * 0.08, 2 * 0.06)
                .turned(body(0, 0, 1), 0.1)
                .turned(body(1, 0, 0), 0.2)
                .mass(400 * 8 * 0.1 * 0.08 * 0.06)
                .at((0.02, 0, 0.01))]),
            points: [grip = (0.05, 0, 0.1)],
        },
    ],
    joints: [
        lift = revolute(world(0, 0, 1), post.origin, body(0, 1, 0)),
        roll = revolute(post.roll, boom.origin, body(1, 0.3, 0)),
        rod_turned = weld(world(0.8, 0.2, 1), rod_frame.origin)
            .turned(body(0, 1, 0), 0.3)
            .turned(body(0, 0, 1), 0.2),
        swing = spherical(rod_frame.origin, rod.origin),
        away = free(load),
        grip = weld(boom.grip, load.grip)
            .turned(body(0, 0, 1), -0.5081726178353302)
            .turned(body(0, 1, 0), 0.7940218707958673)
            .turned(body(1, 0, 0), 0.17787526300607653),
        pin = spherical(rod.pin, boom.pin),
    ],
    fields: [gravity = mass * world(0, 0, -9.81)],
    potentials: [cable_spring = 3 / 2 * (0.5 * lift.angle - 0).powi(2)],
    drives: [
        law_on_lift = (2
            * ((7 + 0.2 * 2 * lift.angle + -0.3 * 2 * lift.angular_velocity) * law
                + 2
                + -5 * 2 * lift.angle
                + -1 * 2 * lift.angular_velocity))
            .on(lift),
        servo_on_roll = (0.5
            * (9 * servo + -9 * 0.5 * roll.angle + -0.3 * 0.5 * roll.angular_velocity))
            .on(roll),
        loose_on_lift = (2 * (1 * loose + -1 * 2 * lift.angle)).on(lift),
        brake_on_roll = (2 * (-0.3 * 2 * roll.angular_velocity * brake)).on(roll),
        tuned_on_lift =
            (2 * (3 * tuned + -3 * 2 * lift.angle + -0.3 * 2 * lift.angular_velocity)).on(lift),
        strong_on_roll = (2
            * (2.5 * strong + -2.5 * 2 * roll.angle + -0.3 * 2 * roll.angular_velocity))
            .on(roll),
        firm_on_lift =
            (2 * (2.5 * firm + -2.5 * 2 * lift.angle + -0.3 * 2 * lift.angular_velocity)).on(lift),
        slack_on_roll = (2.5 * slack + -2.5 * roll.angle + -0.3 * roll.angular_velocity).on(roll),
        paced_on_lift = (2 * (3 * paced + -3 * 2 * lift.angular_velocity)).on(lift),
        inner_on_roll =
            (3 * (7 * inner + -7 * 3 * roll.angle + -2 * 3 * roll.angular_velocity)).on(roll),
        same_on_lift =
            (3 * (1.5 * same + -1.5 * 3 * lift.angle + -2 * 3 * lift.angular_velocity)).on(lift),
        plain_on_roll = (3 * (1 * plain)).on(roll),
        bare_on_lift = (3 * bare).on(lift),
        nearest_on_roll = (0.7 * (1 * nearest + -1 * 0.7 * roll.angle)).on(roll),
        beside_on_lift =
            (3 * (1.5 * beside + -1.5 * 3 * lift.angle + -2 * 3 * lift.angular_velocity)).on(lift),
        reset_on_roll = (3 * (1 * reset + -1 * 3 * roll.angular_velocity)).on(roll),
        braked_on_lift = (3 * (-0.4 * 3 * lift.angular_velocity * braked)).on(lift),
    ],
});
