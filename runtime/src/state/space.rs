//! The space of states.

use core::ops::{Add, Mul, Sub};

/// A point of the space of states, as an integrator needs it.
///
/// That space is a product of straight lines and rotations, so states cannot be added. A state is
/// moved by a displacement, an element of the tangent space at that state. Angular displacements
/// are rotation vectors in body axes, as angular velocities are.
///
/// ```
/// use newton_euler::prelude::*;
///
/// let turning = Rotation { angular_velocity: [0.0, 0.0, 2.0].into(), ..Rotation::default() };
/// let later = turning.moved(&(turning.rate(&[0.0, 0.0, 0.5].into()) * 0.1));
/// assert!((later.attitude.angle() - 0.2).abs() < 1e-15);
/// assert!((later.angular_velocity.z - 2.05).abs() < 1e-15);
/// ```
pub trait State: Clone + Send {
    /// The number type.
    type Scalar;
    /// The second derivatives of the coordinates; together with the state they determine its rate.
    type Acceleration: Send;
    /// An element of the tangent space.
    type Rate: Copy
        + Add<Output = Self::Rate>
        + Sub<Output = Self::Rate>
        + Mul<Self::Scalar, Output = Self::Rate>;

    /// The derivative of this state with respect to time, given the acceleration in it.
    fn rate(&self, acceleration: &Self::Acceleration) -> Self::Rate;

    /// The state at the end of a displacement: coordinates are added, attitudes become
    /// `attitude * exp(rotation)` and stay unit (see
    /// [`attitude::normalized`](crate::attitude::normalized)).
    #[must_use]
    fn moved(&self, displacement: &Self::Rate) -> Self;
}
