//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(CoupledPrinted {
    inputs: [
        turn[N * m],
        servo,
        squeeze[m],
        spindle[rad / s],
        brake,
        law,
        pull[N],
        haul,
        shift[m],
        still[m],
        whirl[rad / s],
        pace[m / s],
        push,
        wind[N],
        tighten,
    ],
    bodies: [
        post {
            inertia: compose([principal(
                1.2 * ((1 - 2 * 0.03
                    / (3 * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt()
                        / 2)
                        + 2 * 0.03))
                    * (0.03.powi(2) / 4
                        + (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.03
                        / (3 * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.03)
                        * (2 / 5 * 0.03.powi(2)
                            + (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.03)),
                1.2 * ((1 - 2 * 0.03
                    / (3 * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt()
                        / 2)
                        + 2 * 0.03))
                    * (0.03.powi(2) / 4
                        + (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.03
                        / (3 * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.03)
                        * (2 / 5 * 0.03.powi(2)
                            + (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.03)),
                1.2 * 0.03.powi(2)
                    * ((1 - 2 * 0.03
                        / (3 * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2))
                            .sqrt()
                            / 2)
                            + 2 * 0.03))
                        / 2
                        + 2 * 0.03
                            / (3 * (((0 - 0.4).powi(2) + (0 - 0).powi(2) + (0 - 0.1).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.03)
                            * 2
                            / 5)
            )
            .turned(
                body(-(0 - 0), 0 - 0.4, 0),
                ((0 - 0.4).powi(2) + (0 - 0).powi(2)).sqrt().atan2(0 - 0.1)
            )
            .mass(1.2)
            .at(((0 + 0.4) / 2, (0 + 0) / 2, (0 + 0.1) / 2))]),
            points: [origin = (0, 0, 0), lift = (0.4, 0, 0.1)],
        },
        boom_after_lift {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
        boom {
            inertia: compose([cuboid(2 * 0.2, 2 * 0.03, 2 * 0.02)
                .mass(0.8)
                .at((0.2, 0.01, 0))]),
            points: [
                origin = (0, 0, 0),
                close_1 = (0.4, 0.02, 0),
                close_2 = (0.4, -0.02, 0),
            ],
        },
        thumb {
            inertia: compose([cuboid(2 * 0.05, 2 * 0.01, 2 * 0.02).mass(0.1).at((0, 0, 0))]),
            points: [
                origin = (0, 0, 0),
                close_1 = origin + body(0, 0, 0) - -0.01 * body(0, 1, 0).normalize(),
            ],
        },
        finger {
            inertia: compose([cuboid(2 * 0.05, 2 * 0.01, 2 * 0.02).mass(0.1).at((0, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
        flywheel {
            inertia: compose([cylinder(0.2, 2 * 0.02).mass(2).at((0, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
        pendulum {
            inertia: compose([principal(
                0.5 * ((1 - 2 * 0.02
                    / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt() / 2)
                        + 2 * 0.02))
                    * (0.02.powi(2) / 4
                        + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.02
                        / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2)
                            + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.02)),
                0.5 * ((1 - 2 * 0.02
                    / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt() / 2)
                        + 2 * 0.02))
                    * (0.02.powi(2) / 4
                        + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.02
                        / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02)
                        * (2 / 5 * 0.02.powi(2)
                            + (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.02)),
                0.5 * 0.02.powi(2)
                    * ((1 - 2 * 0.02
                        / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.02))
                        / 2
                        + 2 * 0.02
                            / (3 * (((0 - 0).powi(2) + (0 - 0).powi(2) + (0 - -0.7).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.02)
                            * 2
                            / 5)
            )
            .mass(0.5)
            .at(((0 + 0) / 2, (0 + 0) / 2, (0 + -0.7) / 2))]),
            points: [origin = (0, 0, 0), wag = (0, 0, -0.7)],
        },
        bob {
            inertia: compose([sphere(0.05).mass(0.7).at((0.1, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
        cart {
            inertia: compose([cuboid(2 * 0.1, 2 * 0.1, 2 * 0.1).mass(1).at((0, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
        mast {
            inertia: compose([principal(
                0.9 * ((1 - 2 * 0.03
                    / (3 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt()
                        / 2)
                        + 2 * 0.03))
                    * (0.03.powi(2) / 4
                        + (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.03
                        / (3 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.03)
                        * (2 / 5 * 0.03.powi(2)
                            + (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.03)),
                0.9 * ((1 - 2 * 0.03
                    / (3 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt()
                        / 2)
                        + 2 * 0.03))
                    * (0.03.powi(2) / 4
                        + (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt() / 2)
                            .powi(2)
                            / 3)
                    + 2 * 0.03
                        / (3 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt()
                            / 2)
                            + 2 * 0.03)
                        * (2 / 5 * 0.03.powi(2)
                            + (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2)).sqrt()
                                / 2)
                            .powi(2)
                            + 3 / 4
                                * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2))
                                    .sqrt()
                                    / 2)
                                * 0.03)),
                0.9 * 0.03.powi(2)
                    * ((1 - 2 * 0.03
                        / (3 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2))
                            .sqrt()
                            / 2)
                            + 2 * 0.03))
                        / 2
                        + 2 * 0.03
                            / (3 * (((0 - 0.1).powi(2) + (0 - 0).powi(2) + (0 - 0.6).powi(2))
                                .sqrt()
                                / 2)
                                + 2 * 0.03)
                            * 2
                            / 5)
            )
            .turned(
                body(-(0 - 0), 0 - 0.1, 0),
                ((0 - 0.1).powi(2) + (0 - 0).powi(2)).sqrt().atan2(0 - 0.6)
            )
            .mass(0.9)
            .at(((0 + 0.1) / 2, (0 + 0) / 2, (0 + 0.6) / 2))]),
            points: [
                origin = (0, 0, 0),
                ride = (0, 0, 0.6),
                trail = (0.1, 0, 0.2),
            ],
        },
        slider {
            inertia: compose([cuboid(2 * 0.1, 2 * 0.05, 2 * 0.05).mass(0.3).at((0, 0, 0))]),
            points: [origin = (0, 0, 0), flap = (0, 0.1, 0)],
        },
        vane {
            inertia: compose([cuboid(2 * 0.1, 2 * 0.02, 2 * 0.1).mass(0.2).at((0.1, 0, 0))]),
            points: [origin = (0, 0, 0)],
        },
        trailer {
            inertia: compose([cuboid(2 * 0.05, 2 * 0.05, 2 * 0.1).mass(0.4).at((0, 0, 0))]),
            points: [origin = (0, 0, 0), sway = (0, 0, 0.1)],
        },
        fin {
            inertia: compose([cuboid(2 * 0.02, 2 * 0.1, 2 * 0.1).mass(0.1).at((0, 0.1, 0))]),
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        pan = revolute(world(0, 0, 1), post.origin, body(0, 0, 1))
            .turned(body(0, 0, 1), -20[deg])
            .armature(0.01),
        lift = revolute(post.lift, boom_after_lift.origin, body(0, 1, 0.2))
            .turned(body(0, 1, 0), 20[deg])
            .armature(0.3),
        roll = revolute(boom_after_lift.origin, boom.origin, body(1, 0, 0)),
        close_1 = prismatic(boom.close_1, thumb.close_1, body(0, 1, 0)).armature(0.2),
        close_2 = prismatic(boom.close_2, finger.origin, body(0, 1, 0)).armature(0.01),
        spin = revolute(world(0, 0, 2), flywheel.origin, body(1, 0, 0))
            .turned(body(1, 0, 0), --10[deg])
            .armature(0.01),
        swing = revolute(world(0, 1, 2), pendulum.origin, body(1, 0, 0)).armature(0.01),
        wag = revolute(pendulum.wag, bob.origin, body(0, 1, 0)).armature(0.01),
        run = prismatic(world(0, 2, 0), cart.origin, body(1, 0, 0)).armature(0.01),
        tilt = revolute(world(0, 3, 1), mast.origin, body(0, 1, 0))
            .turned(body(0, 1, 0), -15[deg])
            .armature(0.01),
        ride = prismatic(mast.ride, slider.origin, body(1, 0, 0.2)).armature(0.01),
        flap = revolute(slider.flap, vane.origin, body(0, 0, 1)).armature(0.01),
        trail = prismatic(mast.trail, trailer.origin, body(0, 0.3, 1)).armature(0.01),
        sway = revolute(trailer.sway, fin.origin, body(1, 0, 0)).armature(0.01),
    ],
    fields: [gravity = mass * world(1, 0, -9.81)],
    potentials: [
        cable_spring = 12 / 2 * (0.3 * swing.angle + -0.5 * wag.angle - 0.2).powi(2),
        belt_spring = 5 / 2 * (0.1 * pan.angle + 0.2 * lift.angle - 0).powi(2),
        strap_spring = 1 / 2 * (1 * tilt.angle + 1 * ride.position - 0).powi(2),
    ],
    constraints: [
        grip = close_2.position - (0.005 + -1 * (close_1.position - 0.01)),
        coupling_2 = spin.angle
            - -10[deg]
            - (0.1
                + 2 * (pan.angle - 20[deg])
                + -0.5 * (pan.angle - 20[deg]).powi(2)
                + 0.3 * (pan.angle - 20[deg]).powi(3)
                + 0.1 * (pan.angle - 20[deg]).powi(4)),
        coupling_3 = 2 * run.position
            - (1.5 * (0.3 * swing.angle + -0.5 * wag.angle)
                + 0.2 * (0.3 * swing.angle + -0.5 * wag.angle).powi(2)),
        coupling_4 = trail.position - 1 * (tilt.angle - 15[deg]),
        coupling_5 = sway.angle
            - (0.1
                + 1 * ride.position
                + 1 * ride.position.powi(2)
                + 1 * ride.position.powi(3)
                + 1 * ride.position.powi(4)),
        coupling_6 = 1 * flap.angle - 1 * run.position,
    ],
    drives: [
        cable_damping_on_swing =
            (0.3 * (-0.4 * (0.3 * swing.angular_velocity + -0.5 * wag.angular_velocity))).on(swing),
        cable_damping_on_wag =
            (-0.5 * (-0.4 * (0.3 * swing.angular_velocity + -0.5 * wag.angular_velocity))).on(wag),
        rope_damping_on_run = (2 * (-0.4 * 2 * run.velocity)).on(run),
        strap_damping_on_tilt =
            (1 * (-1 * (1 * tilt.angular_velocity + 1 * ride.velocity))).on(tilt),
        strap_damping_on_ride =
            (1 * (-1 * (1 * tilt.angular_velocity + 1 * ride.velocity))).on(ride),
        twist_damping_on_tilt =
            (1 * (-0.4 * (1 * tilt.angular_velocity + 1 * flap.angular_velocity))).on(tilt),
        twist_damping_on_flap =
            (1 * (-0.4 * (1 * tilt.angular_velocity + 1 * flap.angular_velocity))).on(flap),
        turning_damping_on_flap = (1 * (-0.4 * 1 * flap.angular_velocity)).on(flap),
        sliding_damping_on_run = (1 * (-0.4 * 1 * run.velocity)).on(run),
        turn_on_pan = (3 * turn).on(pan),
        servo_on_lift =
            (2 * (90 * servo + -90 * 2 * lift.angle + -3 * 2 * lift.angular_velocity)).on(lift),
        squeeze_on_close_1 = (20 * squeeze + -20 * close_1.position).on(close_1),
        spindle_on_roll = (0.7 * spindle + -0.7 * roll.angular_velocity).on(roll),
        brake_on_swing = (-0.2 * swing.angular_velocity * brake).on(swing),
        law_on_wag = (-1.5
            * ((0.5 + 0.2 * -1.5 * wag.angle + -0.1 * -1.5 * wag.angular_velocity) * law
                + 0.3
                + -2 * -1.5 * wag.angle
                + -0.4 * -1.5 * wag.angular_velocity))
            .on(wag),
        pull_on_swing = (0.3 * (4 * pull)).on(swing),
        pull_on_wag = (-0.5 * (4 * pull)).on(wag),
        haul_on_pan = (0.1
            * (7 * haul
                + -7 * (0.1 * pan.angle + 0.2 * lift.angle)
                + -0.6 * (0.1 * pan.angular_velocity + 0.2 * lift.angular_velocity)))
            .on(pan),
        haul_on_lift = (0.2
            * (7 * haul
                + -7 * (0.1 * pan.angle + 0.2 * lift.angle)
                + -0.6 * (0.1 * pan.angular_velocity + 0.2 * lift.angular_velocity)))
            .on(lift),
        shift_on_ride = (1 * shift + -1 * ride.position).on(ride),
        still_on_ride = (0 * still).on(ride),
        whirl_on_tilt = (1 * whirl + -1 * tilt.angular_velocity).on(tilt),
        pace_on_ride = (2 * (1 * pace + -1 * 2 * ride.velocity)).on(ride),
        push_on_ride = (1 * push).on(ride),
        wind_on_tilt = (1 * wind).on(tilt),
        wind_on_flap = (1 * wind).on(flap),
        tighten_on_tilt = (1 * (1 * tighten + -1 * (1 * tilt.angle + 1 * ride.position))).on(tilt),
        tighten_on_ride = (1 * (1 * tighten + -1 * (1 * tilt.angle + 1 * ride.position))).on(ride),
    ],
});
