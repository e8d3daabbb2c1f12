//! The state of a body that moves freely in space.

use nalgebra::{SVector, UnitQuaternion, Vector3};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::mechanics::attitude;
use crate::numbers::scalar::Scalar;

/// State of `motion: spatial`, six degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Spatial<T: Scalar> {
    /// Position of G, world axes \[m\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub position: Vector3<T>,
    /// Takes body components to world components.
    #[cfg_attr(feature = "serde", serde(with = "attitude::checked"))]
    pub attitude: UnitQuaternion<T>,
    /// Velocity of G, world axes \[m/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub velocity: Vector3<T>,
    /// Angular velocity, body axes \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub angular_velocity: Vector3<T>,
}

/// Acceleration of a [`Spatial`] state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct SpatialAcceleration<T: Scalar> {
    /// Acceleration of G, world axes \[m/s²\].
    pub linear: Vector3<T>,
    /// Angular acceleration, body axes \[rad/s²\]: the derivatives of the components of the angular
    /// velocity, which are the components of its derivative (1.7).
    pub angular: Vector3<T>,
}

impl<T: Scalar> Default for Spatial<T> {
    fn default() -> Self {
        Self {
            position: Vector3::default(),
            attitude: attitude::generic::identity(),
            velocity: Vector3::default(),
            angular_velocity: Vector3::default(),
        }
    }
}

impl<T: Scalar> State for Spatial<T> {
    type Scalar = T;
    type Acceleration = SpatialAcceleration<T>;
    /// Velocity, angular velocity, acceleration of G, angular acceleration: three components each.
    type Rate = SVector<T, 12>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &SpatialAcceleration<T>) -> Self::Rate {
        let [v, w] = [self.velocity, self.angular_velocity];
        let [a, b] = [acceleration.linear, acceleration.angular];
        SVector::from([v.x, v.y, v.z, w.x, w.y, w.z, a.x, a.y, a.z, b.x, b.y, b.z])
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<3>(0),
            attitude: attitude::generic::turned(
                &self.attitude,
                &displacement.fixed_rows::<3>(3).into(),
            ),
            velocity: self.velocity + displacement.fixed_rows::<3>(6),
            angular_velocity: self.angular_velocity + displacement.fixed_rows::<3>(9),
        }
    }
}
