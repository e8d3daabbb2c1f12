//! The four families of loads.

#[cfg(feature = "serde")]
use serde::Serialize;

/// The four families of loads: each has forces (odd sums of (1.4)) and moments (even sums).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub enum Family {
    /// From constraints: `R_v`, `M_v`.
    Reaction,
    /// Passed by joints: `F_s`, `M_s`.
    Joint,
    /// From outside: `F_ext`, `M_ext`.
    External,
    /// From fields: `F_f`, `M_f`.
    Field,
}
