//! `checks` that hold, so that this compiles. Each is true by a law; their false counterparts are
//! in `tests/compile_fail/checks/`. Here, the same quantities are computed in doubles.
#![allow(missing_docs, reason = "tests")]

use nalgebra::Vector3;
use newton_euler::prelude::*;

// equilibrium, symmetry and signs of a quadrotor
rigid_body!(Quadrotor {
    motion: spatial,
    params: [arm = 0.17[m], pull = 9.81[m / s ^ 2]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 1.2[kg],
    inertia: principal(0.011, 0.011, 0.021)[kg * m ^ 2],
    points: [
        front = (arm, 0, 0),
        left = (0, arm, 0),
        back = (-arm, 0, 0),
        right = (0, -arm, 0)
    ],
    locals: [
        total = thrust_1 + thrust_2 + thrust_3 + thrust_4,
        share = mass * pull / 4
    ],
    fields: [weight = mass * world(0, 0, -pull)],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front),
        lift_2 = body(0, 0, thrust_2).at(left),
        lift_3 = body(0, 0, thrust_3).at(back),
        lift_4 = body(0, 0, thrust_4).at(right),
    ],
    outputs: [energy],
    checks: [
        hover = (acceleration.norm() < 1e-12[m / s ^ 2]
            && angular_acceleration.norm() < 1e-12[rad / s ^ 2])
            .given(
                thrust_1 = share,
                thrust_2 = share,
                thrust_3 = share,
                thrust_4 = share,
                attitude = turned(world(0, 0, 1), 40[deg]),
                angular_velocity = body(0, 0, 2)[rad / s],
            ),
        exactly = (acceleration.norm() == 0[m / s ^ 2]).given(
            thrust_1 = share,
            thrust_2 = share,
            thrust_3 = share,
            thrust_4 = share,
            attitude = turned(world(0, 0, 1), 40[deg])
        ),
        pitches = (angular_acceleration.in_body().y < 0[rad / s ^ 2]
            && angular_acceleration.in_body().x == 0[rad / s ^ 2])
            .given(
                thrust_1 = 3[N],
                thrust_2 = 2[N],
                thrust_3 = 2[N],
                thrust_4 = 2[N],
                angular_velocity = body(0, 0, 0)[rad / s]
            ),
        // upside down it falls at twice the rate
        dives = (acceleration.in_world().z == -2 * pull).given(
            thrust_1 = share,
            thrust_2 = share,
            thrust_3 = share,
            thrust_4 = share,
            attitude = turned(world(1, 2, 0), 180[deg])
        ),
        tilted = (acceleration.in_world().z == -pull / 2
            && acceleration.in_world().y == -pull * 3.sqrt() / 2)
            .given(
                thrust_1 = share,
                thrust_2 = share,
                thrust_3 = share,
                thrust_4 = share,
                attitude = turned(world(1, 0, 0), 60[deg])
            ),
        budget = (total <= 12[N] && total != 0[N]).given(
            thrust_1 = share,
            thrust_2 = share,
            thrust_3 = share,
            thrust_4 = share
        ),
        spins = (kinetic_energy == 0.5 * 0.021[kg * m ^ 2] * (2[rad / s]).powi(2)).given(
            velocity = world(0, 0, 0)[m / s],
            angular_velocity = body(0, 0, 2)[rad / s]
        ),
        lighter = (acceleration.in_world().z > 0[m / s ^ 2]).given(
            pull = 1.62[m / s ^ 2],
            thrust_1 = 1[N],
            thrust_2 = thrust_1,
            thrust_3 = thrust_1,
            thrust_4 = thrust_1,
            attitude = turned(world(0, 0, 1), 0)
        ),
    ],
});

// a pendulum: sine and cosine at angles of which nothing is known exactly; the force of its pin
rigid_body!(Pendulum {
    motion: pivot(pin),
    params: [arm = 0.5[m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, arm)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    reactions: [hold = world(_, _).at(pin)],
    outputs: [reactions],
    checks: [
        rests = (angular_acceleration == 0[rad / s ^ 2]
            && hold.in_world().y == 2[kg] * 9.81[m / s ^ 2])
            .given(angle = 0, angular_velocity = 0[rad / s]),
        falls = (angular_acceleration < -8[rad / s ^ 2]
            && angular_acceleration > -16.36[rad / s ^ 2])
            .given(angle = 1[rad]),
        // m l (g sin + ..): the law of sines at an angle that is no ratio of pi
        law = (angular_acceleration
            == -2[kg] * 9.81[m / s ^ 2] * arm * (0.3).sin()
                / (0.1[kg * m ^ 2] + 2[kg] * arm.powi(2)))
        .given(angle = 0.3[rad]),
        // nothing proves both equal, and bounds tell how near they are
        doubled = (((2 * attitude).sin() - 2 * attitude.sin() * attitude.cos()).abs() < 1e-100)
            .given(angle = 0.3[rad]),
        odd = (angular_acceleration > 0[rad / s ^ 2]).given(angle = -1e-200[rad]),
        upright =
            (potential_energy - 2[kg] * 9.81[m / s ^ 2] * arm == 0[J]).given(angle = 180[deg]),
    ],
});

// a system: states of joints, momenta, conserved quantities
rigid_system!(Double {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.3, 0), tip = (0.3, 0)]
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.2, 0), tip = (0.2, 0)]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge)
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(shoulder)],
    checks: [
        hangs = (shoulder.angular_acceleration == 0[rad / s ^ 2]
            && elbow.angular_acceleration == 0[rad / s ^ 2])
            .given(
                shoulder.angle = -90[deg],
                elbow.angle = 0,
                torque = 0[N * m]
            ),
        held = (shoulder.angular_acceleration == 0[rad / s ^ 2]).given(
            shoulder.angle = -90[deg],
            elbow.angle = 0,
            torque = 0[N * m],
            shoulder.angular_velocity = 3[rad / s],
            elbow.angular_velocity = 0[rad / s]
        ),
        // the lower arm swings along, 0.8 m from the shoulder
        carried = (elbow.force.in_world().y == 0.8[kg] * (9.81[m / s ^ 2] + 9[1 / s ^ 2] * 0.8[m])
            && elbow.force.in_world().x == 0[N]
            && elbow.moment == 0[N * m])
            .given(
                shoulder.angle = -90[deg],
                elbow.angle = 0,
                torque = 0[N * m],
                shoulder.angular_velocity = 3[rad / s],
                elbow.angular_velocity = 0[rad / s]
            ),
        driven = (shoulder.moment == torque).given(
            shoulder.angle = 20[deg],
            elbow.angle = 40[deg],
            torque = 0.7[N * m],
            shoulder.angular_velocity = 3[rad / s],
            elbow.angular_velocity = 1[rad / s]
        ),
        tip_is_fast = (lower.tip.velocity().norm() == 2[m / s]).given(
            shoulder.angle = 0.7[rad],
            elbow.angle = 0,
            shoulder.angular_velocity = 2[rad / s],
            elbow.angular_velocity = 0[rad / s]
        ),
        energy_of_both = (kinetic_energy > 0[J] && energy < 20[J]).given(
            shoulder.angle = 0.1[rad],
            elbow.angle = 0.2[rad],
            shoulder.angular_velocity = 1[rad / s],
            elbow.angular_velocity = -1[rad / s]
        ),
    ],
});

// a loop: the joint that closes it carries its link and half of the seat
rigid_system!(Swing {
    motion: planar,
    bodies: [
        left {
            mass: 0.3[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [top = (0, 0.5), end = (0, -0.5)]
        },
        seat {
            mass: 4[kg],
            inertia: 0.5[kg * m ^ 2],
            points: [l = (-0.4, 0), r = (0.4, 0)]
        },
        right {
            mass: 0.3[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [top = (0, 0.5), end = (0, -0.5)]
        },
    ],
    joints: [
        one = revolute(world(0, 0), left.top),
        two = revolute(left.end, seat.l),
        three = revolute(seat.r, right.end),
        four = revolute(world(0.8, 0), right.top),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    checks: [
        halved = (four.force.in_world().y == 2.3[kg] * 9.81[m / s ^ 2]
            && two.force.in_world().y == 2[kg] * 9.81[m / s ^ 2])
            .given(
                one.angle = 0,
                two.angle = 0,
                three.angle = 0,
                one.angular_velocity = 0[rad / s],
                two.angular_velocity = 0[rad / s],
                three.angular_velocity = 0[rad / s]
            ),
    ],
});

rigid_system!(Freed {
    bodies: [
        hub {
            mass: 5[kg],
            inertia: principal(1, 0.8, 1.2)[kg * m ^ 2],
            points: [q = (0.3, 0, 0)]
        },
        wheel {
            mass: 1[kg],
            inertia: principal(0.1, 0.1, 0.2)[kg * m ^ 2]
        },
    ],
    joints: [
        base = free(hub),
        spin = revolute(hub.q, wheel.G, body(0, 0, 1))
    ],
    checks: [
        // nothing acts, and nothing drifts
        rests = (hub.acceleration.norm() == 0[m / s ^ 2]
            && spin.angular_acceleration == 0[rad / s ^ 2])
            .given(
                base.attitude = turned(world(1, 1, 1), 33[deg]),
                base.angular_velocity = hub.body(0, 0, 0)[rad / s],
                spin.angle = 0.3[rad],
                spin.angular_velocity = 5[rad / s]
            ),
        momentum = (linear_momentum.norm() == 18[kg * m / s]).given(
            base.attitude = turned(world(1, 0, 0), 90[deg]),
            base.angular_velocity = world(0, 0, 0)[rad / s],
            base.velocity = world(1, 2, 2)[m / s],
            spin.angle = 0,
            spin.angular_velocity = 0[rad / s]
        ),
    ],
});

#[test]
fn what_is_claimed_is_so_in_doubles() {
    let quadrotor = Quadrotor::default();
    let share = 1.2 * 9.81 / 4.0;
    let input = QuadrotorInput {
        thrust_1: share,
        thrust_2: share,
        thrust_3: share,
        thrust_4: share,
    };
    let tilted =
        nalgebra::UnitQuaternion::from_scaled_axis(Vector3::x() * core::f64::consts::FRAC_PI_3);
    let state = Spatial {
        attitude: tilted,
        ..Spatial::default()
    };
    let found = quadrotor.acceleration(0.0, &state, &input).linear;
    assert!(
        (found.z + 9.81 / 2.0).abs() < 1e-14 && (found.y + 9.81 * 0.75_f64.sqrt()).abs() < 1e-14
    );

    let pendulum = Pendulum::default();
    let aside = Hinge {
        angle: 1.0,
        angular_velocity: 0.0,
    };
    let found = pendulum.acceleration(0.0, &aside, &());
    assert!(-16.36 < found && found < -8.0);
    assert!((pendulum.reactions(0.0, &Hinge::default(), &()).hold.y - 19.62).abs() < 1e-13);

    let double = Double::default();
    let hanging = DoubleState {
        shoulder: Hinge {
            angle: -core::f64::consts::FRAC_PI_2,
            angular_velocity: 0.0,
        },
        ..DoubleState::default()
    };
    let found = double.acceleration(0.0, &hanging, &DoubleInput { torque: 0.0 });
    assert!(found.shoulder.abs() < 1e-14 && found.elbow.abs() < 1e-14);
    let found = Freed::default().acceleration(0.0, &FreedState::default(), &());
    assert!(found.spin.abs() < 1e-15);
}

// no load depends on an acceleration, and the checks ask for those of bodies and points
rigid_system!(Trailed {
    motion: planar,
    bodies: [
        arm {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [pin = (1, 0), far = (-1, 0)],
        },
        ball {
            mass: 2[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [tip = (1, 0)]
        },
    ],
    joints: [hinge = revolute(world(0, 0), arm.pin), flight = free(ball)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    checks: [
        // m g l / (J + m l^2)
        falls = (arm.angular_acceleration == 9.81 / 1.1[rad / s ^ 2]).given(hinge.angle = 0),
        at_center = (arm.acceleration.in_world().y == -9.81 / 1.1[m / s ^ 2]
            && arm.acceleration.in_world().x == 4[m / s ^ 2]
            && arm.far.acceleration().in_world().y == -2 * 9.81 / 1.1[m / s ^ 2])
            .given(hinge.angle = 0, hinge.angular_velocity = 2[rad / s]),
        free = (ball.acceleration.in_world().y == -9.81[m / s ^ 2]
            && ball.tip.acceleration().in_world().x == -4[m / s ^ 2])
            .given(flight.angle = 0, flight.angular_velocity = 2[rad / s]),
    ],
});

#[test]
fn accelerations_of_a_system() {
    let state = TrailedState {
        hinge: Hinge {
            angle: 0.0,
            angular_velocity: 2.0,
        },
        ..TrailedState::default()
    };
    let found = Trailed::default().acceleration(0.0, &state, &());
    assert!((found.hinge - 9.81 / 1.1).abs() < 1e-14);
    assert!((found.flight.linear.y + 9.81).abs() < 1e-14);
}
