//! States of a rigid body and how they move.
//!
//! One struct for each kind of `motion`. In all of them `position` and `velocity` are those of the center of mass G in
//! world axes \[m, m/s\], `attitude` takes body components to world components, and `angular_velocity` is in body axes
//! \[rad/s\]; planar angles are anticlockwise from world x to body x \[rad\], not wrapped. The default state is at
//! rest at the origin, body axes along world axes.

use core::ops::{Add, Mul, Sub};

mod coordinates;
#[cfg(feature = "serde")]
mod finite;
mod hinge;
mod planar;
mod rod;
mod rotation;
mod spatial;
mod translation;

pub use coordinates::Coordinates;

/// States and accelerations over any [`Scalar`](crate::Scalar); their aliases in [`state`](crate::state) are those of `f64`.
pub mod generic {
    pub use super::hinge::Hinge;
    pub use super::planar::{Planar, PlanarAcceleration, PlanarTranslation};
    pub use super::rod::{Rod, RodAcceleration};
    pub use super::rotation::Rotation;
    pub use super::spatial::{Spatial, SpatialAcceleration};
    pub use super::translation::Translation;
}

/// A point of the space of states: what an integrator needs to know of it.
///
/// That space is a product of straight lines and rotations, so states are not added: a state is moved by a
/// displacement, an element of the tangent space at that state. Angular displacements are rotation vectors in body
/// axes, as angular velocities are.
///
/// ```
/// use newton_euler::prelude::*;
///
/// let turning = Rotation { angular_velocity: [0.0, 0.0, 2.0].into(), ..Rotation::default() };
/// let later = turning.moved(&(turning.rate(&[0.0, 0.0, 0.5].into()) * 0.1));
/// assert!((later.attitude.angle() - 0.2).abs() < 1e-15);
/// assert!((later.angular_velocity.z - 2.05).abs() < 1e-15);
/// ```
pub trait State: Clone {
    /// The number type.
    type Scalar;
    /// The second derivatives of the coordinates, which with the state fix its rate.
    type Acceleration;
    /// An element of the tangent space.
    type Rate: Copy
        + Add<Output = Self::Rate>
        + Sub<Output = Self::Rate>
        + Mul<Self::Scalar, Output = Self::Rate>;

    /// The derivative of this state with respect to time, given the acceleration in it.
    fn rate(&self, acceleration: &Self::Acceleration) -> Self::Rate;

    /// The state at the end of a displacement: coordinates are added, attitudes become `attitude * exp(rotation)`
    /// and stay unit (see [`attitude::normalized`](crate::attitude::normalized)).
    #[must_use]
    fn moved(&self, displacement: &Self::Rate) -> Self;
}

/// State of `motion: spatial`, six degrees of freedom.
pub type Spatial = generic::Spatial<f64>;
/// Acceleration of a [`Spatial`] state.
pub type SpatialAcceleration = generic::SpatialAcceleration<f64>;
/// State of `motion: rotation` and `motion: fixed_point`, three degrees of freedom.
pub type Rotation = generic::Rotation<f64>;
/// State of `motion: translation`, three degrees of freedom; body axes stay along world axes.
pub type Translation = generic::Translation<f64>;
/// State of `motion: planar`, three degrees of freedom.
pub type Planar = generic::Planar<f64>;
/// Acceleration of a [`Planar`] state.
pub type PlanarAcceleration = generic::PlanarAcceleration<f64>;
/// State of `motion: planar_translation`, two degrees of freedom; body axes stay along world axes.
pub type PlanarTranslation = generic::PlanarTranslation<f64>;
/// State of `motion: pivot` and `motion: fixed_axis`, one degree of freedom; its acceleration is a scalar \[rad/s²\].
pub type Hinge = generic::Hinge<f64>;
/// State of `motion: rod(axis)`, five degrees of freedom.
pub type Rod = generic::Rod<f64>;
/// Acceleration of a [`Rod`].
pub type RodAcceleration = generic::RodAcceleration<f64>;
