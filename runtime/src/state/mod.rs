//! States of a rigid body and how they move.
//!
//! One struct for each kind of `motion`. In all of them `position` and `velocity` are those of the
//! center of mass G in world axes \[m, m/s\], `attitude` takes body components to world components,
//! and `angular_velocity` is in body axes \[rad/s\]; planar angles are anticlockwise from world x
//! to body x \[rad\], not wrapped. The default state is at rest at the origin, body axes along
//! world axes.

mod coordinates;
#[cfg(feature = "serde")]
mod finite;
mod hinge;
mod planar;
mod rod;
mod rotation;
mod space;
mod spatial;
mod translation;

pub use coordinates::Coordinates;
pub use space::State;

/// States and accelerations over any [`Scalar`](crate::Scalar); their aliases in
/// [`state`](crate::state) are those of `f64`.
pub mod generic {
    pub use super::hinge::Hinge;
    pub use super::planar::{Planar, PlanarAcceleration, PlanarTranslation};
    pub use super::rod::{Rod, RodAcceleration};
    pub use super::rotation::Rotation;
    pub use super::spatial::{Spatial, SpatialAcceleration};
    pub use super::translation::Translation;
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
