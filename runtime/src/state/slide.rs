//! The state of a body that slides along a fixed direction.

use nalgebra::Vector2;
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of a body that slides along a direction, one degree of freedom; its acceleration is a
/// scalar \[m/s²\].
///
/// ```
/// use newton_euler::prelude::*;
///
/// let cart = Slide { position: 0.5, velocity: 2.0 };
/// let later = cart.moved(&(cart.rate(&-1.0) * 0.1));
/// assert_eq!(later, Slide { position: 0.7, velocity: 1.9 });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Slide<T: Scalar> {
    /// Position along the direction \[m\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub position: T,
    /// Rate of the position \[m/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub velocity: T,
}

impl<T: Scalar> State for Slide<T> {
    type Scalar = T;
    type Acceleration = T;
    /// Velocity, acceleration.
    type Rate = Vector2<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &T) -> Self::Rate {
        Vector2::new(self.velocity, *acceleration)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.x,
            velocity: self.velocity + displacement.y,
        }
    }
}
