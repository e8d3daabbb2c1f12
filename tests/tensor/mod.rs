//! Tensors as they are observed through bodies, and their comparison.
#![allow(dead_code, reason = "each test needs its part")]

use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};
use newton_euler::prelude::*;

/// The tensor of a body, read off its angular momentum: J e, column by column.
pub fn tensor<B>(body: &B) -> Matrix3<f64>
where
    B: Momentum<Scalar = f64, State = Rotation, Angular = Vector3<f64>>,
{
    let column = |angular_velocity: Vector3<f64>| {
        body.angular_momentum(&Rotation {
            angular_velocity,
            ..Rotation::default()
        })
    };
    Matrix3::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()].map(column))
}

/// Diagonal, and each moment the expected one to one unit in the last place.
pub fn is_diagonal(computed: &Matrix3<f64>, expected: [f64; 3]) {
    assert_eq!(
        computed - Matrix3::from_diagonal(&computed.diagonal()),
        Matrix3::zeros()
    );
    for (computed, expected) in computed.diagonal().iter().zip(expected) {
        let error = (computed - expected).abs();
        assert!(
            error <= f64::EPSILON * expected,
            "{computed} is not {expected}"
        );
    }
}

pub fn is(computed: &Matrix3<f64>, expected: &Matrix3<f64>, tolerance: f64) {
    let error = (computed - expected).amax();
    assert!(
        error <= tolerance,
        "{computed} is not {expected}: off by {error:e}"
    );
}

/// A rotation about an axis of any length.
pub fn turn(axis: [f64; 3], angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Unit::new_normalize(axis.into()), angle)
}
