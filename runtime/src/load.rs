//! A single load on the body, as the balances (1.3) and (1.4) list them.

#[cfg(feature = "serde")]
use serde::Serialize;

pub mod generic;

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
pub type Load = generic::Load<f64>;

/// A [`Load`] in the plane.
pub type PlanarLoad = generic::PlanarLoad<f64>;
