//! The state of a body that rotates about a fixed axis.

use nalgebra::Vector2;
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of `motion: pivot` and `motion: fixed_axis`, one degree of freedom; its acceleration is a
/// scalar \[rad/s²\].
///
/// ```
/// use newton_euler::prelude::*;
///
/// let wheel = Hinge { angle: 0.5, angular_velocity: 2.0 };
/// let later = wheel.moved(&(wheel.rate(&-1.0) * 0.1));
/// assert_eq!(later, Hinge { angle: 0.7, angular_velocity: 1.9 });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Hinge<T: Scalar> {
    /// Zero with body axes along world axes; right-handed about the axis, in the plane
    /// counterclockwise; not wrapped \[rad\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angle: T,
    /// Rate of the angle \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angular_velocity: T,
}

impl<T: Scalar> State for Hinge<T> {
    type Scalar = T;
    type Acceleration = T;
    /// Angular velocity, angular acceleration.
    type Rate = Vector2<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &T) -> Self::Rate {
        Vector2::new(self.angular_velocity, *acceleration)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            angle: self.angle + displacement.x,
            angular_velocity: self.angular_velocity + displacement.y,
        }
    }
}
