//! Tables and constants of a description.

use crate::numbers::scalar::Scalar;

/// The value of a table. Each of its polynomials is given by its start, and by the coefficients of
/// the powers of the distance from there. The first one also holds below its start. All are
/// evaluated, so that lanes take the same path as a single number.
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounded to the precision of the scalar"
)]
pub fn table<T: Scalar, const N: usize>(x: T, pieces: &[(f64, [f64; N])]) -> T {
    let number = |value: f64| x.constant(value, value as f32);
    let mut start = x.constant(f64::NAN, f32::NAN);
    let mut coefficients = [start; N];
    for (place, (from, own)) in pieces.iter().enumerate() {
        let from = number(*from);
        let below = x.less(from);
        let keep = |known: T, new: T| {
            if place == 0 {
                new
            } else {
                T::select(below, known, new)
            }
        };
        start = keep(start, from);
        for (known, new) in coefficients.iter_mut().zip(own) {
            *known = keep(*known, number(*new));
        }
    }
    let beyond = x - start;
    let zero = number(0.0);
    let powers = coefficients.into_iter().rev();
    powers.fold(zero, |sum, one| sum * beyond + one)
}

/// A constant of the user, in the precision of the scalar.
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
#[allow(
    clippy::cast_possible_truncation,
    reason = "rounded to the precision of the scalar"
)]
pub fn constant<T: Scalar>(value: f64) -> T {
    T::default().constant(value, value as f32)
}
