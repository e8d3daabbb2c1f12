//! How large a change of a state is, and which step that permits.

use crate::numbers::scalar::Scalar;
use crate::state::{Coordinates, group};

/// The size of a change of coordinates: of position, attitude, velocity, angular velocity each the
/// largest component, relative to the largest component of the quantity itself where that is above
/// 1, absolute (m, rad, m/s, rad/s) below; and of these the largest. What is not a number may be
/// passed over.
#[inline(always)]
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
        // the quotient is there before the size is
        largest = larger(largest, size * (one / larger(whole, one)));
    }
    largest
}

#[inline(always)]
pub(in crate::integrate) fn largest_of<T: Scalar>(numbers: &[T]) -> T {
    let mut largest = T::default();
    for number in numbers {
        largest = larger(largest, number.abs());
    }
    largest
}

/// One instruction, where `f64::max` looks for what is not a number.
#[inline(always)]
pub(in crate::integrate) fn larger<T: Scalar>(a: T, b: T) -> T {
    T::select(b.less(a), a, b)
}

/// A tolerance, of what is finer than rounding the finest that there is; what is no tolerance is
/// zero, which no step keeps.
pub(crate) fn finest(tolerance: f64) -> f64 {
    if tolerance > 0.0 {
        tolerance.max(1e-18)
    } else {
        0.0
    }
}

/// `(a / b)^(1/k)` to a few parts in a hundred, which is all that a step needs: the bits of a
/// double are its logarithm, with straight lines between the powers of two. Of what has no
/// logarithm, the quotient itself.
#[inline(always)]
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
