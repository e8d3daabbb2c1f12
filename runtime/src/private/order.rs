//! What recurrences read of the order n of a coefficient.

use crate::numbers::count::real;

/// n
#[inline(always)]
#[must_use]
pub fn order(n: usize) -> f64 {
    real(n)
}

/// 1/n
#[inline(always)]
#[must_use]
pub fn inverse(n: usize) -> f64 {
    1.0 / real(n)
}

/// Coefficient n of time, n > 0.
#[inline(always)]
#[must_use]
pub fn time(n: usize) -> f64 {
    if n == 1 { 1.0 } else { 0.0 }
}
