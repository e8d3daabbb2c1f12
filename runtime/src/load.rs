//! A single load on the body, as the balances (1.3) and (1.4) list them.

use nalgebra::{Vector2, Vector3};
#[cfg(feature = "serde")]
use serde::Serialize;

/// The four families of loads: each has forces (odd sums of (1.4)) and moments (even sums).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub enum Family {
    /// Of constraints: `R_v`, `M_v`.
    Reaction,
    /// Passed by joints: `F_s`, `M_s`.
    Joint,
    /// From outside: `F_ext`, `M_ext`.
    External,
    /// Standing for fields: `F_f`, `M_f`.
    Field,
}

/// A force at a point, or a couple, or both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct Load {
    /// Its name in the description.
    pub name: &'static str,
    /// The family it was declared in.
    pub family: Family,
    /// The force, world axes \[N\].
    pub force: Vector3<f64>,
    /// Where it acts: world position, or from G in world axes if G's motion is not modelled (`rotation`) \[m\].
    pub point: Vector3<f64>,
    /// The couple, world axes, without the moment of the force \[N m\].
    pub moment: Vector3<f64>,
}

/// A [`Load`] in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct PlanarLoad {
    /// Its name in the description.
    pub name: &'static str,
    /// The family it was declared in.
    pub family: Family,
    /// The force, world axes \[N\].
    pub force: Vector2<f64>,
    /// Where it acts, world position \[m\].
    pub point: Vector2<f64>,
    /// The couple, positive anticlockwise, without the moment of the force \[N m\].
    pub moment: f64,
}
