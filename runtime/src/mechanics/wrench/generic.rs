//! Wrenches over any [`Scalar`].

use nalgebra::{Vector2, Vector3};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

use crate::numbers::scalar::Scalar;

/// Force and moment about a pole, in one set of axes.
///
/// The operations are those of [`wrench::Wrench`](crate::wrench::Wrench), for `f64`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct Wrench<T: Scalar> {
    /// Resultant force \[N\].
    pub force: Vector3<T>,
    /// Moment about the pole \[N m\].
    pub moment: Vector3<T>,
}

/// Force and moment in the plane, the moment positive counterclockwise.
///
/// The operations are those of [`wrench::PlanarWrench`](crate::wrench::PlanarWrench), for `f64`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
pub struct PlanarWrench<T: Scalar> {
    /// Resultant force \[N\].
    pub force: Vector2<T>,
    /// Moment about the pole, counterclockwise \[N m\].
    pub moment: T,
}
