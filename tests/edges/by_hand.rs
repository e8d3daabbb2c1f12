//! The parts of the runtime that users call directly.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::Scalar;
use newton_euler::attitude;
use newton_euler::exact::{FreeRotation, Jacobi, LagrangeTop, Path, Pendulum, r_j};
use newton_euler::prelude::*;
use newton_euler::wrench::Reduction;

use crate::bounded;

const NONE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

#[test]
fn an_inertia_is_refused() {
    for number in NONE {
        assert!(InertiaTensor::principal(number, 1.0, 1.0).is_err());
        assert!(InertiaTensor::tensor(1.0, 1.0, 1.0, number, 0.0, 0.0).is_err());
        assert!(InertiaTensor::from_matrix(&Matrix3::repeat(number)).is_err());
        let ball = InertiaTensor::principal(1.0, 1.0, 1.0).unwrap();
        assert!(ball.shifted_from_center(number, &Vector3::x()).is_err());
        assert!(
            ball.shifted_to_center(1.0, &(Vector3::x() * number))
                .is_err()
        );
    }
}

#[test]
fn attitudes_and_wrenches_hand_it_on() {
    for number in NONE {
        let rotation = Vector3::new(number, 0.1, 0.2);
        assert!(attitude::exp(&rotation).coords.iter().any(|q| q.is_nan()));
        assert!(
            attitude::turned(&UnitQuaternion::identity(), &rotation)
                .w
                .is_nan()
        );
        let lost = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(number, 0.0, 0.0, 0.0));
        let _ = attitude::log(&lost);
        let reduced =
            |force: Vector3<f64>, moment: Vector3<f64>| (Wrench { force, moment }).reduce();
        assert_ne!(reduced(rotation, Vector3::y()), Reduction::Zero);
        assert_ne!(reduced(Vector3::y(), rotation), Reduction::Zero);
    }
    let lost = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(f64::NAN, 0.0, 0.1, 0.0));
    assert!(attitude::log(&lost).y.is_nan());
}

/// Whatever they are set up from, closed forms come to an end.
#[test]
fn closed_forms_end() {
    bounded("closed forms", || {
        let numbers = [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MAX,
            f64::MIN,
            1e-308,
            5e-324,
            0.0,
            -0.0,
            1.0,
        ];
        let body = InertiaTensor::principal(1.0, 2.0, 2.5).unwrap();
        for x in numbers {
            for y in numbers {
                let _ = Jacobi::new(x).at(y);
                let hinge = Hinge {
                    angle: x,
                    angular_velocity: y,
                };
                for z in numbers {
                    let angular_velocity = Vector3::new(x, y, z);
                    let state = Rotation {
                        angular_velocity,
                        ..Rotation::default()
                    };
                    let free = FreeRotation::new(&body, &state);
                    let top =
                        LagrangeTop::new([2.0, 1.0], Vector3::z_axis(), Vector3::z() * x, &state);
                    let swing = Pendulum::new(z, 0.0, &hinge);
                    for time in [0.7, f64::MAX, f64::NAN] {
                        let _ = (free.at(time), top.at(time), swing.at(time));
                    }
                    for p in numbers {
                        let _ = r_j(x, y, z, p);
                    }
                }
            }
        }
    });
}

/// `R_J(4 x, ..) = R_J(x, ..) / 8`, at the ends of the range of numbers as well: B. C. Carlson.
#[test]
fn the_third_kind_has_any_size() {
    let near = r_j(1.0, 2.0, 3.0, 4.0);
    let sized = |half: i32| {
        let four = 2.0_f64.powi(2 * half);
        r_j(four, 2.0 * four, 3.0 * four, 4.0 * four)
    };
    for half in [-500, -300, -1, 1, 300, 340, 500] {
        assert_eq!(
            sized(half),
            near * 2.0_f64.powi(-half) * 2.0_f64.powi(-2 * half),
            "{half}"
        );
    }
    assert_eq!(r_j(f64::INFINITY, 1.0, 1.0, 1.0), 0.0);
    assert!(r_j(f64::NAN, 1.0, 1.0, 1.0).is_nan() && r_j(-1.0, -1.0, -2.0, -1.0).is_nan());
}

/// Of zeros the second, of a number and what is none the number, in both precisions.
#[test]
fn the_smaller_and_the_larger() {
    for [first, second] in [[0.0_f64, -0.0], [-0.0, 0.0]] {
        assert_eq!(Scalar::min(first, second).to_bits(), second.to_bits());
        assert_eq!(Scalar::max(first, second).to_bits(), second.to_bits());
    }
    for [first, second] in [[0.0_f32, -0.0], [-0.0, 0.0]] {
        assert_eq!(Scalar::min(first, second).to_bits(), second.to_bits());
        assert_eq!(Scalar::max(first, second).to_bits(), second.to_bits());
    }
    for smaller in [
        Scalar::min(1.0, f64::NAN),
        Scalar::min(f64::NAN, 1.0),
        Scalar::min(1.0, 2.0),
    ] {
        assert_eq!(smaller, 1.0);
    }
    for larger in [
        Scalar::max(1.0, f64::NAN),
        Scalar::max(f64::NAN, 1.0),
        Scalar::max(1.0, 0.5),
    ] {
        assert_eq!(larger, 1.0);
    }
    assert!(Scalar::min(f64::NAN, f64::NAN).is_nan());
}
