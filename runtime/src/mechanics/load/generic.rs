//! Loads over any [`Scalar`].

use nalgebra::{Vector2, Vector3};
#[cfg(feature = "serde")]
use serde::Serialize;

use super::family::Family;
use crate::numbers::scalar::Scalar;

/// A force at a point, or a couple, or both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct Load<T: Scalar> {
    /// Its name in the description.
    pub name: &'static str,
    /// The family it was declared in.
    pub family: Family,
    /// The force, world axes \[N\].
    pub force: Vector3<T>,
    /// The point of action: world position, or from G in world axes if G's motion is not modeled
    /// (`rotation`) \[m\].
    pub point: Vector3<T>,
    /// The couple, world axes, without the moment of the force \[N m\].
    pub moment: Vector3<T>,
}

/// A [`Load`] in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct PlanarLoad<T: Scalar> {
    /// Its name in the description.
    pub name: &'static str,
    /// The family it was declared in.
    pub family: Family,
    /// The force, world axes \[N\].
    pub force: Vector2<T>,
    /// The point of action, world position \[m\].
    pub point: Vector2<T>,
    /// The couple, positive counterclockwise, without the moment of the force \[N m\].
    pub moment: T,
}
