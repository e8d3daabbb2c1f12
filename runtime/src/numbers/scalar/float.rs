//! Doubles, with the elementary functions of libm, and single precision, with its own sine.

use super::Scalar;
use crate::numbers::{math, single};

/// `Scalar` for a primitive type: which of the two constants it takes, its sine and cosine, and all
/// other functions.
macro_rules! primitive {
    ($float:ident, $constant:expr, $sin_cos:path, {
        $($name:ident($($argument:ident),*) = $function:path;)*
    }) => {
        impl Scalar for $float {
            type Truth = bool;
            const EPSILON: f64 = $float::EPSILON as f64;
            const LANES: usize = 1;

            #[cfg_attr(not(unoptimized), inline(always))]
            fn constant(self, double: f64, single: f32) -> Self {
                $constant(double, single)
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn lane(self, _: usize) -> f64 {
                f64::from(self)
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn less(self, other: Self) -> bool {
                self < other
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn less_or_equal(self, other: Self) -> bool {
                self <= other
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            #[allow(clippy::float_cmp)]
            fn equal(self, other: Self) -> bool {
                self == other
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn select(truth: bool, first: Self, second: Self) -> Self {
                if truth { first } else { second }
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn agreed(truth: bool) -> Option<bool> {
                Some(truth)
            }

            $(#[cfg_attr(not(unoptimized), inline(always))]
            fn $name(self, $($argument: Self),*) -> Self {
                $function(self, $($argument),*)
            })*

            #[cfg_attr(not(unoptimized), inline(always))]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
        }
    };
}

primitive!(f64, |double, _| double, math::sin_cos, {
    sin() = math::sin;
    cos() = math::cos;
    tan() = math::tan;
    asin() = math::asin;
    acos() = math::acos;
    atan() = math::atan;
    atan2(other) = math::atan2;
    sinh() = math::sinh;
    cosh() = math::cosh;
    tanh() = math::tanh;
    exp() = math::exp;
    ln() = math::ln;
    powf(exponent) = math::powf;
    sqrt() = math::sqrt;
    cbrt() = math::cbrt;
    hypot(other) = math::hypot;
    abs() = math::abs;
    signum() = math::signum;
    floor() = math::floor;
    ceil() = math::ceil;
    min(other) = math::min;
    max(other) = math::max;
});

primitive!(f32, |_, single| single, single::sin_cos, {
    sin() = single::sin;
    cos() = single::cos;
    tan() = libm::tanf;
    asin() = libm::asinf;
    acos() = libm::acosf;
    atan() = libm::atanf;
    atan2(other) = libm::atan2f;
    sinh() = libm::sinhf;
    cosh() = libm::coshf;
    tanh() = libm::tanhf;
    exp() = libm::expf;
    ln() = libm::logf;
    powf(exponent) = libm::powf;
    sqrt() = libm::sqrtf;
    cbrt() = libm::cbrtf;
    hypot(other) = libm::hypotf;
    abs() = f32::abs;
    signum() = f32::signum;
    floor() = libm::floorf;
    ceil() = libm::ceilf;
    min(other) = math::min;
    max(other) = math::max;
});
