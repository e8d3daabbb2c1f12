//! The state of a body that slides along a fixed axis and rotates about it.

use nalgebra::Vector4;
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

#[cfg(feature = "serde")]
use super::finite;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of a body that slides along an axis and rotates about it, two degrees of freedom.
///
/// ```
/// use newton_euler::prelude::*;
///
/// let piston = Cylinder { position: 0.5, velocity: 2.0, ..Cylinder::default() };
/// let turned = CylinderAcceleration { linear: -1.0, angular: 3.0 };
/// let later = piston.moved(&(piston.rate(&turned) * 0.1));
/// assert_eq!((later.position, later.velocity), (0.7, 1.9));
/// assert!((later.angular_velocity - 0.3).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(deserialize = "T: Scalar + Deserialize<'de>"))
)]
pub struct Cylinder<T: Scalar> {
    /// Position along the axis \[m\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub position: T,
    /// Right-handed about the axis, not wrapped \[rad\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angle: T,
    /// Rate of the position \[m/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub velocity: T,
    /// Rate of the angle \[rad/s\].
    #[cfg_attr(feature = "serde", serde(deserialize_with = "finite::scalar"))]
    pub angular_velocity: T,
}

/// Acceleration of a [`Cylinder`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct CylinderAcceleration<T: Scalar> {
    /// Along the axis \[m/s²\].
    pub linear: T,
    /// About the axis \[rad/s²\].
    pub angular: T,
}

impl<T: Scalar> State for Cylinder<T> {
    type Scalar = T;
    type Acceleration = CylinderAcceleration<T>;
    /// Velocity, angular velocity, acceleration, angular acceleration.
    type Rate = Vector4<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, acceleration: &CylinderAcceleration<T>) -> Self::Rate {
        Vector4::new(
            self.velocity,
            self.angular_velocity,
            acceleration.linear,
            acceleration.angular,
        )
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Self::Rate) -> Self {
        Self {
            position: self.position + displacement.x,
            angle: self.angle + displacement.y,
            velocity: self.velocity + displacement.z,
            angular_velocity: self.angular_velocity + displacement.w,
        }
    }
}
