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
    let (mut changes, mut wholes) = (change.as_ref(), coordinates.as_ref());
    let mut largest = zero_like(changes);
    let one = largest.constant(1.0, 1.0);
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
    let mut largest = zero_like(numbers);
    for number in numbers {
        largest = larger(largest, number.abs());
    }
    largest
}

/// Zero. `T::default()` would look for the registers of the processor.
#[cfg_attr(not(unoptimized), inline(always))]
fn zero_like<T: Scalar>(numbers: &[T]) -> T {
    match numbers {
        [first, ..] => first.constant(0.0, 0.0),
        [] => T::default(),
    }
}

/// One instruction; `f64::max` would check for NaN.
#[cfg_attr(not(unoptimized), inline(always))]
pub(in crate::integrate) fn larger<T: Scalar>(a: T, b: T) -> T {
    T::select(b.less(a), a, b)
}

/// A valid tolerance: values below rounding become the finest useful one, and an invalid tolerance
/// becomes zero, which no step satisfies.
pub(crate) fn finest(tolerance: f64) -> f64 {
    if tolerance > 0.0 && tolerance < f64::INFINITY {
        tolerance.max(1e-18)
    } else {
        0.0
    }
}

/// `(a / b)^(1/k)` to a few percent, which suffices for a step. If the quotient has no logarithm,
/// the quotient itself.
#[cfg_attr(not(unoptimized), inline(always))]
pub(in crate::integrate) fn root(a: f64, b: f64, k: usize) -> f64 {
    let has_logarithm = |x: f64| x > 0.0 && x < f64::INFINITY;
    if has_logarithm(a) && has_logarithm(b) {
        near_root(a, b, k)
    } else {
        a / b
    }
}

/// The same, for numbers with logarithms: the upper bits of a double approximate its logarithm,
/// linearly between powers of two.
#[cfg_attr(not(unoptimized), inline(always))]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "signs are plus, k is small"
)]
pub(in crate::integrate) fn near_root(a: f64, b: f64, k: usize) -> f64 {
    let upper = |x: f64| (x.to_bits() >> 32) as i32;
    let logarithm = upper(a).wrapping_sub(upper(b)) / k.max(1) as i32;
    let bits = upper(1.0).wrapping_add(logarithm);
    f64::from_bits((bits.clamp(0, upper(f64::MAX)) as u64) << 32)
}
