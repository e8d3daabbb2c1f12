//! Divisors that depend on the configuration, and positive quantities.

use crate::bodies::body::Singular;
use crate::numbers::scalar::Scalar;

/// The reciprocal of the divisor of an unknown, where it depends on the configuration, given the
/// largest of the terms of its sum.
///
/// # Errors
/// [`Singular`] if it is NaN, or zero to [`Singular::TOLERANCE`] of that term in units of the
/// scalar's precision.
#[cfg_attr(not(unoptimized), inline(always))]
pub fn reciprocal<T: Scalar>(unknown: &'static str, divisor: T, scale: T) -> Result<T, Singular> {
    let tolerance = Singular::TOLERANCE / f64::EPSILON * T::EPSILON;
    for lane in 0..T::LANES {
        let (value, scale) = (divisor.lane(lane), scale.lane(lane));
        let is_determined = value.abs() > tolerance * scale;
        if !is_determined {
            return Err(Singular {
                unknown,
                value,
                scale,
            });
        }
    }
    Ok(divisor.constant(1.0, 1.0) / divisor)
}

/// The same where no error can be returned, for each number separately: NaN if the divisor is
/// nothing but rounding.
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn determined<T: Scalar>(divisor: T, scale: T) -> T {
    let eight = divisor.constant(8.0 * f64::EPSILON, 8.0 * f32::EPSILON);
    let is_determined = (eight * scale).less(divisor.abs());
    let reciprocal = divisor.constant(1.0, 1.0) / divisor;
    T::select(
        is_determined,
        reciprocal,
        divisor.constant(f64::NAN, f32::NAN),
    )
}

/// A positive quantity, such as a mass; NaN if it is not positive.
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn positive<T: Scalar>(value: T) -> T {
    let zero = value.constant(0.0, 0.0);
    T::select(zero.less(value), value, value.constant(f64::NAN, f32::NAN))
}
