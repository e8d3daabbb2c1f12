//! Where the balances do not determine what is asked.

use core::fmt;

/// A configuration in which the balances do not determine what is asked.
///
/// Solving them divides by a quantity that depends on the configuration and vanishes in this one,
/// such as the sine of the angle between two guides: there its load is undetermined, or grows
/// beyond bounds.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singular {
    /// The unknown that a division would have given.
    pub unknown: &'static str,
    /// Its divisor.
    pub value: f64,
    /// The largest of the terms it was summed from.
    pub scale: f64,
}

impl Singular {
    /// A divisor not above this fraction of its largest term is singular: eight units in the last
    /// place, which a sum of a few rounded products may leave of zero. What is above has lost
    /// digits in proportion, but is determined.
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
            "singular configuration: the divisor of `{unknown}` is {value:e}, nothing but rounding of terms of size {scale}"
        )
    }
}

impl core::error::Error for Singular {}
