//! Binary numbers of so many bits.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// Bits kept of a number that is not rational.
pub(in crate::symbolic) const PRECISION: usize = 256;

/// A binary number of so many bits.
pub(in crate::symbolic) type Float = FBig<HalfEven, 2>;
