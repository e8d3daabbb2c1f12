//! Random states, and sums that record the sizes of their terms.
#![allow(dead_code, reason = "each test uses its part")]

use nalgebra::{SVector, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

pub fn vectors(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

pub fn plane_vectors(size: f64) -> impl Strategy<Value = Vector2<f64>> {
    prop::array::uniform2(-size..size).prop_map(Vector2::from)
}

pub fn attitudes() -> impl Strategy<Value = UnitQuaternion<f64>> {
    vectors(3.0).prop_map(UnitQuaternion::from_scaled_axis)
}

pub fn spatial() -> impl Strategy<Value = Spatial> {
    (vectors(5.0), attitudes(), vectors(4.0), vectors(3.0)).prop_map(
        |(position, attitude, velocity, angular_velocity)| Spatial {
            position,
            attitude,
            velocity,
            angular_velocity,
        },
    )
}

pub fn rotation() -> impl Strategy<Value = Rotation> {
    (attitudes(), vectors(3.0)).prop_map(|(attitude, angular_velocity)| Rotation {
        attitude,
        angular_velocity,
    })
}

pub fn translation() -> impl Strategy<Value = Translation> {
    (vectors(5.0), vectors(4.0)).prop_map(|(position, velocity)| Translation { position, velocity })
}

pub fn planar() -> impl Strategy<Value = Planar> {
    (plane_vectors(5.0), -7.0..7.0, plane_vectors(4.0), -3.0..3.0).prop_map(
        |(position, angle, velocity, angular_velocity)| Planar {
            position,
            angle,
            velocity,
            angular_velocity,
        },
    )
}

pub fn planar_translation() -> impl Strategy<Value = PlanarTranslation> {
    (plane_vectors(5.0), plane_vectors(4.0))
        .prop_map(|(position, velocity)| PlanarTranslation { position, velocity })
}

pub fn rod() -> impl Strategy<Value = Rod> {
    (vectors(5.0), attitudes(), vectors(4.0), plane_vectors(3.0)).prop_map(
        |(position, attitude, velocity, rate)| Rod {
            position,
            velocity,
            axis: attitude * Vector3::x_axis(),
            axis_rate: attitude * Vector3::new(0.0, rate.x, rate.y),
        },
    )
}

/// A sum and the size of its largest term.
///
/// Sizes are products of the norms of the factors: what cancels within a term, such as a component of a turned vector,
/// was computed from numbers that large.
#[derive(Clone, Copy, Debug)]
pub struct Sum<const N: usize> {
    pub value: SVector<f64, N>,
    pub largest: f64,
}

impl<const N: usize> Sum<N> {
    pub fn new() -> Self {
        Self {
            value: SVector::zeros(),
            largest: 0.0,
        }
    }

    /// With a term of this size.
    pub fn and(mut self, term: SVector<f64, N>, size: f64) -> Self {
        assert!(
            term.norm() <= size * 1.0001,
            "a term is never larger than its size"
        );
        self.value += term;
        self.largest = self.largest.max(size);
        self
    }
}

/// Within 64 units in the last place of the largest term: some forty operations lie between a state and a component of
/// an answer, each rounding by at most half a unit of what it makes.
pub fn is<const N: usize>(
    computed: &SVector<f64, N>,
    expected: &Sum<N>,
) -> Result<(), TestCaseError> {
    let error = (computed - expected.value).amax();
    let unit = expected.largest.next_up() - expected.largest;
    prop_assert!(
        error <= 64.0 * unit,
        "{computed} is not {}: off by {} units",
        expected.value,
        error / unit
    );
    Ok(())
}

/// [`is`] for scalars.
pub fn is_scalar(computed: f64, expected: f64, largest: f64) -> Result<(), TestCaseError> {
    let expected = Sum {
        value: SVector::from([expected]),
        largest,
    };
    is(&SVector::from([computed]), &expected)
}
