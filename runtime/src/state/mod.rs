//! States of a rigid body, and their motion.
//!
//! One struct for each kind of `motion`. In all of them `position` and `velocity` are those of the
//! center of mass G in world axes \[m, m/s\], `attitude` takes body components to world components,
//! and `angular_velocity` is in body axes \[rad/s\]; planar angles are counterclockwise from world x
//! to body x \[rad\], not wrapped. The default state is at rest at the origin, body axes along
//! world axes.
//!
//! The state of a system of bodies is a struct with one of these for each joint. It describes the
//! carried body relative to its carrier: positions and velocities are those of the joint's point of
//! the carried body from its point of the carrier, in axes of the carrier; `attitude` takes
//! components in axes of the carried body to those of its carrier, and `angular_velocity` is that
//! of the carried body minus that of its carrier, in axes of the carried body. Coordinates along a
//! direction are positive that way, and those about it right-handed, both for the carried body
//! relative to its carrier.

mod coordinates;
mod cylinder;
#[cfg(feature = "serde")]
mod finite;
mod hinge;
mod list;
mod planar;
mod real;
mod rod;
mod rotation;
mod slide;
mod space;
mod spatial;
mod still;
mod translation;
mod universal;

pub use coordinates::Coordinates;
pub(crate) use coordinates::group;
#[cfg(feature = "serde")]
pub(crate) use finite::check;
pub use list::List;
pub use space::State;

/// States and accelerations over any [`Scalar`](crate::Scalar); their aliases in
/// [`state`](crate::state) are those of `f64`.
pub mod generic {
    pub use super::cylinder::{Cylinder, CylinderAcceleration};
    pub use super::hinge::Hinge;
    pub use super::planar::{Planar, PlanarAcceleration, PlanarTranslation};
    pub use super::rod::{Rod, RodAcceleration};
    pub use super::rotation::Rotation;
    pub use super::slide::Slide;
    pub use super::spatial::{Spatial, SpatialAcceleration};
    pub use super::still::Still;
    pub use super::translation::Translation;
    pub use super::universal::Universal;
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
/// State of `motion: pivot` and `motion: fixed_axis`, one degree of freedom; its acceleration is a
/// scalar \[rad/s²\].
pub type Hinge = generic::Hinge<f64>;
/// State of `motion: rod(axis)`, five degrees of freedom.
pub type Rod = generic::Rod<f64>;
/// Acceleration of a [`Rod`].
pub type RodAcceleration = generic::RodAcceleration<f64>;
/// State of a body that slides along a direction, one degree of freedom; its acceleration is a
/// scalar \[m/s²\].
pub type Slide = generic::Slide<f64>;
/// State of a body that slides along an axis and rotates about it, two degrees of freedom.
pub type Cylinder = generic::Cylinder<f64>;
/// Acceleration of a [`Cylinder`].
pub type CylinderAcceleration = generic::CylinderAcceleration<f64>;
/// State of a body that rotates about two axes in sequence, two degrees of freedom; its
/// acceleration has the second derivatives of both angles \[rad/s²\].
pub type Universal = generic::Universal<f64>;
/// State of a system in which nothing moves by itself, without coordinates.
pub type Still = generic::Still<f64>;
