//! Lagrange's top, for which an integrator may choose other variables: the formulas, and what they
//! cost.
//!
//! The tip is held, at c below G: `k = m g c`, J across and along the axis about the tip, `s` the
//! constant spin, `e` up.

use nalgebra::{Quaternion, Vector3};
use newton_euler::prelude::*;
use newton_euler::structure::{Structured, Symmetry};

use crate::bodies::Top;
use crate::coordinates::Random;
use crate::reference::{Traced, operations};

const ACROSS: f64 = 1.3;
const ALONG: f64 = 0.7;
const K: f64 = 2.0 * 9.8 * 0.3;

type Vector = [Traced; 3];

/// Negations are free.
fn minus(a: Traced) -> Traced {
    Traced {
        value: -a.value,
        ..a
    }
}

/// `q' = q (0, h)`, with the half rate `h = w / 2`.
fn attitude_rate([w, x, y, z]: [Traced; 4], [a, b, c]: Vector) -> [Traced; 4] {
    [
        minus(x * a + y * b + z * c),
        w * a + y * c - z * b,
        w * b + z * a - x * c,
        w * c + x * b - y * a,
    ]
}

fn halved(v: Vector) -> Vector {
    let half = Traced::from(0.5);
    v.map(|part| half * part)
}

/// `h'` across the axis, of the half rate: the numbers are folded.
fn half_acceleration([w, x, y, z]: [Traced; 4], [a, b, c]: Vector) -> [Traced; 2] {
    let precession = Traced::from(2.0 * (ACROSS - ALONG) / ACROSS) * c;
    let drawn = Traced::from(K / ACROSS);
    [
        precession * b + drawn * (y * z + w * x),
        drawn * (w * y - x * z) - precession * a,
    ]
}

/// Rates of `w_1`, `w_2` and of `g = R^T e`; the spin s is no unknown.
fn yaw_free([w_1, w_2]: [Traced; 2], [x, y, z]: Vector, s: f64) -> [Traced; 5] {
    let precession = Traced::from((ACROSS - ALONG) / ACROSS * s);
    let (drawn, s) = (Traced::from(K / ACROSS), Traced::from(s));
    [
        precession * w_2 + drawn * y,
        minus(precession * w_1 + drawn * x),
        y * s - z * w_2,
        z * w_1 - x * s,
        x * w_2 - y * w_1,
    ]
}

fn in_order(q: Quaternion<f64>) -> [f64; 4] {
    [q.w, q.i, q.j, q.k]
}

fn is(computed: Traced, expected: f64) {
    assert!(
        (computed.value - expected).abs() < 1e-13 * (1.0 + computed.largest),
        "{computed:?} is not {expected}"
    );
}

#[test]
fn choices_of_variables() {
    let generated = Top::OPERATIONS
        .iter()
        .find(|row| row.function == "acceleration");
    let generated = generated.expect("every body has one").total();
    // what the third choice needs is a claim of the structure
    let up = Symmetry::About([0.0, 0.0, 1.0]);
    let angular = Top::STRUCTURE.angular;
    assert!(angular.world == up && angular.body == up && Top::STRUCTURE.keeps_spin);

    let mut random = Random(3);
    for _ in 0..1000 {
        let coordinates = random.coordinates();
        let (attitude, w) = (coordinates.attitude, coordinates.angular_velocity);
        let state = Rotation {
            attitude,
            angular_velocity: w,
        };
        let alpha = Top::default().acceleration(0.0, &state, &());
        let q = in_order(*attitude.quaternion()).map(Traced::from);
        let rate: [Traced; 3] = <[f64; 3]>::from(w).map(Traced::from);
        let half: [Traced; 3] = <[f64; 3]>::from(w / 2.0).map(Traced::from);
        let up: [f64; 3] = (attitude.inverse() * Vector3::z()).into();

        // attitude and angular velocity
        let whole = operations(|| {
            attitude_rate(q, halved(rate));
        });
        assert_eq!((generated, generated + whole), (13, 36));

        // attitude and half the angular velocity
        let with_half = operations(|| {
            let [x, y] = half_acceleration(q, half);
            let turning = attitude.quaternion() * Quaternion::from_imag(w / 2.0);
            for (computed, expected) in attitude_rate(q, half).into_iter().zip(in_order(turning)) {
                is(computed, expected);
            }
            is(x, alpha.x / 2.0);
            is(y, alpha.y / 2.0);
        });
        assert_eq!(with_half, 33);

        // no yaw, and no spin
        let without_yaw = operations(|| {
            let [x, y, turning @ ..] = yaw_free([rate[0], rate[1]], up.map(Traced::from), w.z);
            for (computed, expected) in turning.into_iter().zip(&Vector3::from(up).cross(&w)) {
                is(computed, *expected);
            }
            is(x, alpha.x);
            is(y, alpha.y);
        });
        assert_eq!(without_yaw, 15);
    }
}
