//! Binary numbers of fixed precision.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// The precision of an irrational number, in bits.
pub(in crate::symbolic) const PRECISION: usize = 256;

/// A binary number of fixed precision.
pub(in crate::symbolic) type Float = FBig<HalfEven, 2>;
