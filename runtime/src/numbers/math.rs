//! Elementary functions: the names and meanings of std's methods on `f64`, in libm.
//!
//! The whole library, including generated code, takes its elementary functions from here. Results
//! therefore do not depend on the platform's library.

/// Functions of one number, forwarded to libm.
macro_rules! unary {
    ($($name:ident = $function:path, $meaning:literal;)*) => {$(
        #[doc = $meaning]
        #[inline]
        #[must_use]
        pub fn $name(x: f64) -> f64 {
            $function(x)
        }
    )*};
}

/// Functions of two numbers.
macro_rules! binary {
    ($($name:ident($x:ident, $y:ident) = $function:path, $meaning:literal;)*) => {$(
        #[doc = $meaning]
        #[inline]
        #[must_use]
        pub fn $name($x: f64, $y: f64) -> f64 {
            $function($x, $y)
        }
    )*};
}

unary! {
    sin = libm::sin, "Sine.";
    cos = libm::cos, "Cosine.";
    tan = libm::tan, "Tangent.";
    asin = libm::asin, "Inverse sine.";
    acos = libm::acos, "Inverse cosine.";
    atan = libm::atan, "Inverse tangent.";
    sinh = libm::sinh, "Hyperbolic sine.";
    cosh = libm::cosh, "Hyperbolic cosine.";
    tanh = libm::tanh, "Hyperbolic tangent.";
    exp = libm::exp, "Exponential.";
    ln = libm::log, "Natural logarithm.";
    sqrt = libm::sqrt, "Square root: one instruction where the target has it.";
    cbrt = libm::cbrt, "Cube root.";
    floor = libm::floor, "The largest integer not above.";
    ceil = libm::ceil, "The smallest integer not below.";
    abs = f64::abs, "Absolute value.";
    signum = f64::signum, "1 from +0 on, -1 from -0 down, NaN of NaN.";
}

binary! {
    atan2(y, x) = libm::atan2, "The angle of the point (x, y) from the first axis, in (-π, π].";
    powf(x, y) = libm::pow, "x to the power of y.";
    hypot(x, y) = libm::hypot, "√(x² + y²) without overflow.";
}

/// `(sin x, cos x)`, with one reduction of the argument.
#[inline]
#[must_use]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// The smaller; of a number and NaN, the number; of 0 and -0, the second (std's `min` may return
/// either).
#[inline]
#[must_use]
#[expect(clippy::eq_op, reason = "NaN alone is not equal to itself")]
pub fn min<T: Copy + PartialOrd>(x: T, y: T) -> T {
    if x < y || y != y { x } else { y }
}

/// The larger; of a number and NaN, the number; of 0 and -0, the second (std's `max` may return
/// either).
#[inline]
#[must_use]
#[expect(clippy::eq_op, reason = "NaN alone is not equal to itself")]
pub fn max<T: Copy + PartialOrd>(x: T, y: T) -> T {
    if x > y || y != y { x } else { y }
}
