//! Configurations in which the balances do not determine an unknown.

use core::fmt;

use crate::numbers::messages::{Brief, debug_as_display};

/// A configuration in which the balances do not determine an unknown.
///
/// The solution divides by a quantity that depends on the configuration and vanishes here,
/// such as the sine of the angle between two guides. There the load of a guide is undetermined, or
/// grows without bound.
///
/// ```
/// use newton_euler::body::Singular;
///
/// let toggle = Singular { unknown: "knee.normal", value: 1e-17, scale: 0.8 };
/// assert_eq!(
///     toggle.to_string(),
///     "singular configuration: the divisor of `knee.normal` is 1e-17, \
///      nothing but rounding of terms of size 0.8",
/// );
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Singular {
    /// The unknown that is not determined.
    pub unknown: &'static str,
    /// Its divisor.
    pub value: f64,
    /// The largest of the terms of its sum.
    pub scale: f64,
}

impl Singular {
    /// A divisor counts as zero if it is at most this fraction of its largest term: eight units in
    /// the last place, which the rounding of a sum of a few products may leave. A larger divisor
    /// has lost digits in proportion, but is determined.
    pub const TOLERANCE: f64 = 8.0 * f64::EPSILON;
}

impl fmt::Display for Singular {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            unknown,
            value,
            scale,
        } = self;
        write!(
            f,
            "singular configuration: the divisor of `{unknown}` is {}, nothing but rounding of terms of size {}",
            Brief(*value),
            Brief(*scale)
        )
    }
}

debug_as_display!(Singular);

impl core::error::Error for Singular {}
