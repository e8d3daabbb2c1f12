//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(ClassesPrinted {
    inputs: [law, servo],
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
    ],
});
