//! The state of a body that rotates about two axes, the second carried by the first.

use nalgebra::{Vector2, Vector4};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of a body that rotates about two axes in sequence, two degrees of freedom; its
/// acceleration has the second derivatives of both angles \[rad/s²\].
///
/// ```
/// use newton_euler::prelude::*;
///
/// let gimbal = Universal { angle_1: 0.5, angular_velocity_2: 2.0, ..Universal::default() };
/// let later = gimbal.moved(&(gimbal.rate(&[3.0, -1.0].into()) * 0.1));
/// assert_eq!((later.angle_1, later.angle_2), (0.5, 0.2));
/// assert_eq!(later.angular_velocity_2, 1.9);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Universal<T: Scalar> {
    /// About the first axis, right-handed, not wrapped \[rad\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angle_1: T,
    /// About the second axis, which rotates with the first angle, right-handed, not wrapped
    /// \[rad\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angle_2: T,
    /// Rate of the first angle \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angular_velocity_1: T,
    /// Rate of the second angle \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angular_velocity_2: T,
}

impl<T: Scalar> State for Universal<T> {
    type Scalar = T;
    type Acceleration = Vector2<T>;
    /// The rates of both angles, their accelerations.
    type Rate = Vector4<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &Vector2<T>) -> Self::Rate {
        let [first, second] = [self.angular_velocity_1, self.angular_velocity_2];
        Vector4::new(first, second, acceleration.x, acceleration.y)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            angle_1: self.angle_1 + displacement.x,
            angle_2: self.angle_2 + displacement.y,
            angular_velocity_1: self.angular_velocity_1 + displacement.z,
            angular_velocity_2: self.angular_velocity_2 + displacement.w,
        }
    }
}
