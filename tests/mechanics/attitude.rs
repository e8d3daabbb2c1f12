//! Maps of attitudes are accurate everywhere: hazards H4, H5, H6.
//!
//! The oracles are the platform's sine and cosine about coordinate axes, which are not the
//! library's, and the vector law of rotation by Rodrigues.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Quaternion, Unit, UnitQuaternion, Vector3};
use newton_euler::attitude::{exp, kinematics, log, normalized, turned};
use proptest::prelude::*;

use crate::reference::{attitude, distance, numbers, statement, vector};

const ULP: f64 = f64::EPSILON;

/// From nothing, through angles whose square underflows and the switch to series at 0.1, to π.
fn angles() -> Vec<f64> {
    let mut angles = vec![
        0.0,
        f64::MIN_POSITIVE * f64::EPSILON,
        1e-320,
        1e-300,
        1e-170,
        1e-154,
    ];
    angles.extend((-150..=-2).step_by(4).map(|decade| 10f64.powi(decade)));
    angles.extend([
        0.1f64.next_down(),
        0.1,
        0.1f64.next_up(),
        0.5,
        1.0,
        2.0,
        3.0,
    ]);
    angles.extend((1..=12).map(|decade| PI - 10f64.powi(-decade)));
    angles.push(PI);
    angles
}

/// Relative to the value, except below the normal numbers, where a unit in the last place is one.
fn within(computed: f64, expected: f64, ulps: f64) -> bool {
    (computed - expected).abs() <= ulps * (ULP * expected.abs()).max(5e-324)
}

/// H5.
#[test]
fn exponential_about_an_axis() {
    for angle in angles() {
        for axis in 0..3 {
            let mut rotation = Vector3::zeros();
            rotation[axis] = -angle;
            let q = exp(&rotation);
            let (sine, cosine) = (0.5 * angle).sin_cos();
            assert!(
                within(q.w, cosine, 4.0),
                "{angle:e}: {} is not {cosine}",
                q.w
            );
            assert!(
                within(q.imag()[axis], -sine, 4.0),
                "{angle:e}: {:e}",
                q.imag()[axis]
            );
            let other = |k| q.imag()[(axis + k) % 3];
            assert_eq!((other(1), other(2)), (0.0, 0.0));
        }
    }
    for huge in [1e9, 1e150] {
        let q = exp(&Vector3::new(huge, 0.0, 0.0));
        assert!((q.quaternion().norm() - 1.0).abs() <= 4.0 * ULP);
    }
}

/// H6.
#[test]
fn logarithm_about_an_axis() {
    for angle in angles() {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let q = UnitQuaternion::new_unchecked(Quaternion::new(cosine, 0.0, sine, 0.0));
        let rotation = log(&q);
        assert!(
            within(rotation.y, angle, 4.0),
            "{angle:e}: {:e}",
            rotation.y
        );
        assert_eq!((rotation.x, rotation.z), (0.0, 0.0));
        let opposite = UnitQuaternion::new_unchecked(-q.into_inner());
        assert_eq!(log(&opposite), rotation);
    }
    // At π exactly both senses are one rotation; which is a convention, that it is one a promise.
    let half = |z| UnitQuaternion::new_unchecked(Quaternion::new(0.0, 0.0, 0.0, z));
    assert_eq!(log(&half(1.0)), log(&half(-1.0)));
    assert_eq!(log(&half(1.0)), Vector3::new(0.0, 0.0, PI));
}

fn some_axis() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0)
        .prop_map(Vector3::from)
        .prop_filter("of some length", |axis| axis.norm() > 0.1)
        .prop_map(|axis| axis.normalize())
}

fn some_attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    (some_axis(), -PI..PI).prop_map(|(axis, angle)| {
        UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), angle)
    })
}

proptest! {
    #[test]
    fn exponential_is_the_rotation_of_rodrigues(axis in some_axis(), angle in 0.0..PI, v in some_axis()) {
        let (sine, cosine) = angle.sin_cos();
        let expected = v * cosine + axis.cross(&v) * sine + axis * (axis.dot(&v) * (1.0 - cosine));
        // Some thirty roundings of numbers below 2.
        prop_assert!((exp(&(axis * angle)) * v - expected).amax() < 4e-15);
    }

    #[test]
    fn logarithm_undoes_the_exponential(axis in some_axis(), exponent in -300.0..0.0, near_pi in any::<bool>()) {
        let angle = if near_pi { PI - 10f64.powf(exponent / 25.0) } else { 3.0 * 10f64.powf(exponent) };
        let rotation = axis * angle;
        let error = (log(&exp(&rotation)) - rotation).amax();
        prop_assert!(error <= 4.0 * ULP * rotation.amax().max(angle), "{error:e} of {angle:e}");
    }

    #[test]
    fn kinematics_is_the_derivative(q in some_attitude(), w in some_axis()) {
        let h = 1e-5;
        let difference = (turned(&q, &(w * h)).into_inner() - turned(&q, &(w * -h)).into_inner()) / (2.0 * h);
        // The cubic term, h²/48 = 2e-12, and rounding over h, some 1e-11.
        prop_assert!((kinematics(&q, &w).coords - difference.coords).amax() < 1e-10);
    }

    #[test]
    fn one_newton_step(q in some_attitude(), drift in -1e-8..1e-8) {
        let back = normalized(&(q.into_inner() * (1.0 + drift)));
        prop_assert!((back.quaternion().norm() - 1.0).abs() <= 2.0 * ULP);
        prop_assert!(distance(&back, &q) <= 2.0 * ULP);
    }
}

/// H4: |ω| h = 0.1, 1e5 steps about changing axes.
#[test]
fn attitudes_stay_rotations() {
    let mut q = UnitQuaternion::identity();
    for k in 0..100_000 {
        let phase = f64::from(k) * 0.37;
        q = turned(
            &q,
            &(Vector3::new(phase.cos(), phase.sin(), 0.5) * (0.1 / 1.25f64.sqrt())),
        );
        assert!(
            (q.quaternion().norm() - 1.0).abs() <= 4.0 * ULP,
            "after {k} steps"
        );
    }
    let r = q.to_rotation_matrix().into_inner();
    assert!((r * r.transpose() - Matrix3::identity()).amax() <= 1e-15);
    assert!((r.determinant() - 1.0).abs() <= 2e-15);
}

/// Turning by parts about one axis is turning by the whole.
#[test]
fn turns_add_about_one_axis() {
    let step = Vector3::new(0.3, -0.4, 1.2) * 1e-3; // 1.3e-3
    let q = (0..1000).fold(UnitQuaternion::identity(), |q, _| turned(&q, &step));
    assert!(distance(&q, &exp(&(step * 1000.0))) < 1e-14); // a random walk of roundings
}

/// F10: the derivative of the attitude.
#[test]
fn derivative_of_reference() {
    let expected = statement("F10 six scalar equations");
    let rate = kinematics(&attitude(&expected["q"]), &vector(&expected["w body"]));
    for (computed, given) in [rate.w, rate.i, rate.j, rate.k]
        .into_iter()
        .zip(numbers::<4>(&expected["qdot"]))
    {
        assert!((computed - given).abs() < 1e-15);
    }
}
