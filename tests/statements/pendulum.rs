//! The compound pendulum M1 of the theory, through the macro; and a bob on a massless rod.
//!
//! The expected numbers are those of the reference, in 40-digit arithmetic by two routes.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Vector2, Vector3};
use newton_euler::integrate::cf4;
use newton_euler::prelude::*;

use crate::reference::{body, number, numbers};

mod scenes {
    use newton_euler::rigid_body;

    // G is below the pin at the angle zero: body y points up
    rigid_body!(Pendulum {
        motion: pivot(pin),
        params: [m[kg], d[m], about_g[kg * m ^ 2], g[m / s ^ 2]],
        inputs: [torque[N * m]],
        mass: m,
        inertia: about_g,
        points: [pin = (0, d)],
        fields: [weight = mass * world(0, -g)],
        moments: [drive = torque],
        reactions: [hold = world(_, _).at(pin)],
        outputs: [reactions, energy, momentum, balance],
    });

    // the same, with the bearing as a hinge in space, about an axis of its own
    rigid_body!(Hung {
        motion: fixed_axis(pin, world(0, 0, 2)),
        params: [m[kg], d[m], about_g[kg * m ^ 2], g[m / s ^ 2]],
        inputs: [torque[N * m]],
        mass: m,
        inertia: principal(about_g, about_g, about_g),
        points: [pin = (0, d, 0)],
        fields: [weight = mass * world(0, -g, 0)],
        moments: [drive = world(0, 0, torque)],
        reactions: [
            hold = world(_, _, _).at(pin),
            guide = moment(world(_, _, 0))
        ],
        outputs: [reactions],
    });
}
use scenes::{Hung, HungInput, HungParams, Pendulum, PendulumInput, PendulumParams};

/// One-shot algebra: 1e-13 of the largest term, which a sum of a dozen rounded terms leaves far below.
fn is(computed: f64, expected: f64, largest: f64) {
    let error = (computed - expected).abs();
    assert!(
        error <= 1e-13 * largest,
        "{computed} is not {expected}: off by {error:e}"
    );
}

fn is_vector(computed: Vector3<f64>, expected: Vector3<f64>, largest: f64) {
    for (computed, expected) in computed.iter().zip(&expected) {
        is(*computed, *expected, largest);
    }
}

fn given(name: &str) -> f64 {
    number(&body("M1")["given"][name])
}

fn expected(name: &str) -> f64 {
    number(&body("M1")["expect"][name])
}

fn pendulum() -> Pendulum {
    let [m, d, about_g, g] = ["m", "d", "JG", "g"].map(given);
    Pendulum::new(PendulumParams { m, d, about_g, g }).unwrap()
}

fn start() -> Hinge {
    let [angle, angular_velocity] = ["theta", "omega"].map(given);
    Hinge {
        angle,
        angular_velocity,
    }
}

fn drive() -> PendulumInput {
    PendulumInput {
        torque: given("torque"),
    }
}

#[test]
fn acceleration_and_pin_force() {
    let pendulum = pendulum();
    let alpha = pendulum.acceleration(0.0, &start(), &drive());
    is(alpha, expected("alpha"), 12.0);
    let pin = pendulum.reactions(0.0, &start(), &drive()).hold;
    // the weight is 26 N
    is(pin.x, expected("Rx"), 26.5);
    is(pin.y, expected("Ry"), 26.5);
}

#[test]
fn the_same_hinge_in_space() {
    let [m, d, about_g, g] = ["m", "d", "JG", "g"].map(given);
    let hung = Hung::new(HungParams { m, d, about_g, g }).unwrap();
    let input = HungInput {
        torque: given("torque"),
    };
    is(
        hung.acceleration(0.0, &start(), &input),
        expected("alpha"),
        12.0,
    );
    let reactions = hung.reactions(0.0, &start(), &input);
    let pin = Vector3::new(expected("Rx"), expected("Ry"), 0.0);
    is_vector(reactions.hold, pin, 26.5);
    // a plane of symmetry: nothing to guide
    assert_eq!(reactions.guide, Vector3::zeros());
}

#[test]
fn moment_of_inertia_about_the_pin() {
    let pendulum = pendulum();
    let turning = Hinge {
        angle: 0.3,
        angular_velocity: 1.0,
    };
    is(
        2.0 * pendulum.kinetic_energy(&turning),
        expected("J_O"),
        expected("J_O"),
    );
}

#[test]
fn after_three_seconds() {
    let [angle, rate] = numbers(&body("M1")["expect"]["state(t=3) [th,w]"]);
    let at = |steps| cf4(&pendulum(), &start(), &drive(), 0.0..3.0, steps);
    let end = at(16_000);
    // order four: of 4000 steps the error is 256 times larger, and below 1e-8
    assert!((end.angle - angle).abs() < 1e-11, "{:e}", end.angle - angle);
    assert!((end.angular_velocity - rate).abs() < 1e-10);
    let coarse = at(500).angle - angle;
    let fine = at(1000).angle - angle;
    assert!((coarse / fine - 16.0).abs() < 2.0, "{coarse:e}, {fine:e}");
}

/// Released at the amplitude, it is upright again at rest after half a period, with the angle's sign changed.
#[test]
fn period() {
    let period = expected("period for torque=0, amplitude 1.2 (4K/w0)");
    let released = Hinge {
        angle: 1.2,
        angular_velocity: 0.0,
    };
    let no_drive = PendulumInput::default();
    let half = cf4(&pendulum(), &released, &no_drive, 0.0..period / 2.0, 8000);
    assert!((half.angle + 1.2).abs() < 1e-12);
    // the rate passes through zero at 17 rad/s²: the period is off by 2/17 of it
    assert!(half.angular_velocity.abs() < 1e-10, "{half:?}");
}

/// A bob on a rod without mass, as nearly as a body that turns has inertia: the force of the pin is along the rod.
#[test]
fn simple_pendulum() {
    newton_euler::rigid_body!(Bob {
        motion: pivot(pin).at(world(0, 2)[m]),
        params: [length = 0.8[m], speck = 1e-30[kg * m ^ 2]],
        mass: 1.5[kg],
        inertia: speck,
        points: [pin = (0, length)],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        reactions: [rod = body(_, _).at(pin)],
        outputs: [reactions, energy],
    });
    let bob = Bob::default();
    let state = Hinge {
        angle: 0.9,
        angular_velocity: -2.0,
    };
    let alpha = bob.acceleration(0.0, &state, &());
    is(alpha, -9.80665 / 0.8 * 0.9_f64.sin(), 12.3);
    let tension = 1.5 * (9.80665 * 0.9_f64.cos() + 0.8 * 4.0);
    let expected = Vector2::new(-0.9_f64.sin(), 0.9_f64.cos()) * tension;
    let error = bob.reactions(0.0, &state, &()).rod - expected;
    assert!(error.amax() < 1e-13 * 20.0, "{error}");
    // the potential counts from the origin of the world
    let height = 2.0 - 0.8 * 0.9_f64.cos();
    is(
        bob.potential_energy(0.0, &state, &()),
        1.5 * 9.80665 * height,
        30.0,
    );
}

rigid_body!(Bob {
    doc: "A point on a massless rod: no inertia of its own.",
    motion: pivot(pin),
    params: [length = 0.75[m]],
    mass: 2[kg],
    inertia: 0,
    points: [pin = (0, length)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    reactions: [pull = world(_, _).at(pin)],
    outputs: [reactions],
});

/// The degenerate body of which all mass is in one point.
#[test]
fn a_point_on_a_rod() {
    let state = Hinge {
        angle: 0.7,
        angular_velocity: -1.3,
    };
    let bob = Bob::default();
    is(
        bob.acceleration(0.0, &state, &()),
        -8.423_489_843_399_338,
        9.0,
    );
    let pull = bob.reactions(0.0, &state, &()).pull;
    is(pull.x, -11.297_052_431_738_88, 20.0);
    is(pull.y, 13.412_333_226_688_826, 20.0);
    is(pull.norm(), 17.536_079_271_866_857, 20.0);
}
