//! The heavy top M7 of the theory, through the macro: precession, nutation and the force of the
//! pivot.
//!
//! The expected numbers are those of the reference, in 40-digit arithmetic by two routes.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::integrate::{cf4, cf4_step};
use newton_euler::prelude::*;
use newton_euler::top::{HeavyTop, SymmetricTop};

use crate::reference::{attitude, body, distance, number, numbers, vector};

mod scenes {
    use newton_euler::rigid_body;

    rigid_body!(Top {
        motion: fixed_point(tip),
        params: [
            m[kg],
            l[m],
            across[kg * m ^ 2],
            along[kg * m ^ 2],
            g[m / s ^ 2]
        ],
        mass: m,
        inertia: principal(across - m * l.powi(2), across - m * l.powi(2), along),
        points: [tip = (0, 0, -l)],
        fields: [weight = mass * world(0, 0, -g)],
        reactions: [stand = world(_, _, _).at(tip)],
        outputs: [reactions, energy, momentum],
    });
}
use scenes::{Top, TopParams};

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
    number(&body("M7")["given"][name])
}

fn top() -> Top {
    let [m, l, across, along, g] = ["m", "l", "I1", "I3", "g"].map(given);
    Top::new(TopParams {
        m,
        l,
        across,
        along,
        g,
    })
    .unwrap()
}

fn tilted(angular_velocity: Vector3<f64>) -> Rotation {
    Rotation {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), given("theta")),
        angular_velocity,
    }
}

#[test]
fn steady_precession() {
    let (theta, spin) = (given("theta"), given("Omega3"));
    let expect = body("M7")["expect"].take();
    let name = "horizontal, toward axis: m l sin(th) Om^2";
    let horizontal: [f64; 2] = numbers(&expect[name]);
    let vertical = number(&expect["pivot reaction slow: vertical"]);
    for (name, horizontal) in ["slow", "fast"].into_iter().zip(horizontal) {
        let rate = number(&expect[name]);
        let angular_velocity = Vector3::new(0.0, rate * theta.sin(), spin);
        let state = tilted(angular_velocity);
        // in the frame that precesses ω stays: in the body it turns backwards, at the spin
        let relative = spin - rate * theta.cos();
        let expected = Vector3::new(rate * theta.sin() * relative, 0.0, 0.0);
        let alpha = top().acceleration(0.0, &state, &());
        // terms to 9300 rad/s² of gyroscopic moments over I₁
        is_vector(alpha, expected, 15_000.0);
        assert_eq!(alpha.z, 0.0);
        // the axis leans towards -y
        let reaction = top().reactions(0.0, &state, &()).stand;
        let expected = Vector3::new(0.0, horizontal, vertical);
        // m times accelerations of 0.06 m at 15000 rad/s²
        is_vector(reaction, expected, 360.0);
    }
}

#[test]
fn steady_precession_in_time() {
    let (theta, spin) = (given("theta"), given("Omega3"));
    let about_tip = SymmetricTop::new(given("I1"), given("I3")).unwrap();
    let heavy = HeavyTop::new(about_tip, given("m") * given("g") * given("l"));
    let slow = heavy.steady_rates(theta, spin).unwrap().slow;
    is(slow, number(&body("M7")["expect"]["slow"]), slow);
    let motion = heavy.steady(theta, spin, slow);
    let end = cf4(&top(), &motion.at(0.0), &(), 0.0..1.0, 20_000);
    let expected = motion.at(1.0);
    assert!(distance(&end.attitude, &expected.attitude) < 1e-10);
    let error = end.angular_velocity - expected.angular_velocity;
    assert!(error.amax() < 1e-9, "{error}");
}

#[test]
fn nutation() {
    let nutation = body("M7")["nutation"].take();
    let start = tilted(Vector3::new(0.0, 0.0, given("Omega3")));
    let end = cf4(&top(), &start, &(), 0.0..0.5, 20_000);
    let q = attitude(&nutation["q(.5) from NE"]);
    assert!(
        distance(&end.attitude, &q) < 1e-10,
        "{:e}",
        distance(&end.attitude, &q)
    );
    let w = vector(&nutation["w body(.5)"]);
    assert!((end.angular_velocity - w).amax() < 1e-9);
    let reaction = top().reactions(0.5, &end, &()).stand;
    let expected = vector(&nutation["pivot reaction world (.5)"]);
    assert!((reaction - expected).amax() < 1e-9);

    let [theta, theta_rate, phi, _] = numbers(&nutation["t=.5: theta,thetadot,phi,psi"]);
    let axis = end.attitude * Vector3::z();
    assert!((axis.z.acos() - theta).abs() < 1e-10);
    assert!((axis.x.atan2(-axis.y) - phi).abs() < 1e-10);
    // θ' = ω along the line of nodes, z × axis
    let nodes = Vector3::new(phi.cos(), phi.sin(), 0.0);
    let rate = nodes.dot(&(end.attitude * end.angular_velocity));
    assert!((rate - theta_rate).abs() < 1e-9);
}

/// The angle grows to its largest value and returns; there it stands still.
#[test]
fn largest_angle() {
    let start = tilted(Vector3::new(0.0, 0.0, given("Omega3")));
    let tilt = |state: &Rotation| (state.attitude * Vector3::z()).z.acos();
    let (mut state, mut largest, step) = (start, [0.0_f64; 3], 2e-5);
    // three neighbors of the largest, and the parabola through them
    for _ in 0..8000 {
        state = cf4_step(&top(), 0.0, &state, &(), step);
        let [_, b, c] = largest;
        if b > 0.0 && c <= b {
            break;
        }
        largest = [b, c, tilt(&state)];
    }
    let [a, b, c] = largest;
    let top = b - (c - a).powi(2) / (8.0 * (a - 2.0 * b + c));
    let expected = number(&body("M7")["nutation"]["theta_max"]);
    assert!((top - expected).abs() < 1e-10, "{:e}", top - expected);
}
