//! The order n of a coefficient, as recurrences read it.

use crate::numbers::count::real;

/// n
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn order(n: usize) -> f64 {
    real(n)
}

/// 1/n
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn inverse(n: usize) -> f64 {
    1.0 / real(n)
}

/// Coefficient n > 0 of a polynomial in time, by those from order 1 on.
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn given<const COUNT: usize>(n: usize, coefficients: [f64; COUNT]) -> f64 {
    coefficients.get(n.wrapping_sub(1)).copied().unwrap_or(0.0)
}
