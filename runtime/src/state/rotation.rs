//! The state of a body that rotates about G or about a held point.

use nalgebra::{UnitQuaternion, Vector3, Vector6};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::mechanics::attitude;
use crate::numbers::scalar::Scalar;

/// State of `motion: rotation`, three degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Rotation<T: Scalar> {
    /// Takes body components to world components.
    #[cfg_attr(feature = "serde", serde(with = "attitude::checked"))]
    pub attitude: UnitQuaternion<T>,
    /// Angular velocity, body axes \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub angular_velocity: Vector3<T>,
}

impl<T: Scalar> Default for Rotation<T> {
    fn default() -> Self {
        Self {
            attitude: attitude::generic::identity(),
            angular_velocity: Vector3::default(),
        }
    }
}

impl<T: Scalar> State for Rotation<T> {
    type Scalar = T;
    type Acceleration = Vector3<T>;
    /// Angular velocity, angular acceleration: three components each.
    type Rate = Vector6<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &Vector3<T>) -> Self::Rate {
        let [w, b] = [self.angular_velocity, *acceleration];
        Vector6::new(w.x, w.y, w.z, b.x, b.y, b.z)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            attitude: attitude::generic::turned(
                &self.attitude,
                &displacement.fixed_rows::<3>(0).into(),
            ),
            angular_velocity: self.angular_velocity + displacement.fixed_rows::<3>(3),
        }
    }
}
