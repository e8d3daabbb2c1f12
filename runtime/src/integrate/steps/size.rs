//! The size of a change of state, and the step that it permits.

use crate::numbers::scalar::Scalar;
use crate::state::{Coordinates, group};

/// The size of a change of coordinates. For each of position, attitude, velocity and angular
/// velocity it is the largest component, relative to the largest component of the quantity itself
/// if that is above 1, and absolute (m, rad, m/s, rad/s) below; the result is the largest of
/// these. NaN may be ignored.
#[cfg_attr(not(unoptimized), inline(always))]
pub(in crate::integrate) fn relative_size<S: Coordinates>(
    change: &S::Array,
    coordinates: &S::Array,
) -> S::Scalar {
    let mut largest = S::Scalar::default();
    let one = largest.constant(1.0, 1.0);
    let (mut changes, mut wholes) = (change.as_ref(), coordinates.as_ref());
    for count in S::GROUPS {
        let size = largest_of(group(&mut changes, *count));
        let whole = largest_of(group(&mut wholes, *count));
        // computed before the size is known
        largest = larger(largest, size * (one / larger(whole, one)));
    }
    largest
}

#[cfg_attr(not(unoptimized), inline(always))]
pub(in crate::integrate) fn largest_of<T: Scalar>(numbers: &[T]) -> T {
    let mut largest = T::default();
    for number in numbers {
        largest = larger(largest, number.abs());
    }
    largest
}

/// One instruction; `f64::max` would check for NaN.
#[cfg_attr(not(unoptimized), inline(always))]
pub(in crate::integrate) fn larger<T: Scalar>(a: T, b: T) -> T {
    T::select(b.less(a), a, b)
}

/// A valid tolerance: values below rounding become the finest useful one, and an invalid tolerance
/// becomes zero, which no step satisfies.
pub(crate) fn finest(tolerance: f64) -> f64 {
    if tolerance > 0.0 {
        tolerance.max(1e-18)
    } else {
        0.0
    }
}

/// `(a / b)^(1/k)` to a few percent, which suffices for a step: the bits of a
/// double approximate its logarithm, linearly between powers of two. If the quotient has no
/// logarithm, the quotient itself.
#[cfg_attr(not(unoptimized), inline(always))]
#[expect(
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "signs are plus, k is small"
)]
pub(in crate::integrate) fn root(a: f64, b: f64, k: usize) -> f64 {
    let has_logarithm = |x: f64| x > 0.0 && x < f64::INFINITY;
    if !(has_logarithm(a) && has_logarithm(b)) {
        return a / b;
    }
    let logarithm = (a.to_bits() as i64 - b.to_bits() as i64) / k.max(1) as i64;
    let bits = 1.0_f64.to_bits() as i64 + logarithm;
    f64::from_bits(bits.clamp(0, f64::MAX.to_bits() as i64) as u64)
}
