//! The state of a body that does not rotate.

use nalgebra::{Vector3, Vector6};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of `motion: translation`, three degrees of freedom; body axes stay along world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Translation<T: Scalar> {
    /// Position of G, world axes \[m\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub position: Vector3<T>,
    /// Velocity of G, world axes \[m/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::vector"))]
    pub velocity: Vector3<T>,
}

impl<T: Scalar> State for Translation<T> {
    type Scalar = T;
    type Acceleration = Vector3<T>;
    /// Velocity, acceleration of G: three components each.
    type Rate = Vector6<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &Vector3<T>) -> Self::Rate {
        let [v, a] = [self.velocity, *acceleration];
        Vector6::new(v.x, v.y, v.z, a.x, a.y, a.z)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.fixed_rows::<3>(0),
            velocity: self.velocity + displacement.fixed_rows::<3>(3),
        }
    }
}
