//! The number types of a body.
//!
//! A body is written for `f64` unless its description names another scalar:
//! `rigid_body!(Craft::<T> { .. })` is generic over [`Scalar`], and is `Craft<f64>`, `Craft<f32>`,
//! `Craft<Dual<f64, 6>>`, or several bodies in one register. The states of such bodies are those of
//! [`state::generic`](crate::state::generic).

use core::fmt::Debug;
use core::ops::{
    Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign,
};

mod dual;
mod float;
#[cfg(feature = "num-dual")]
mod num_dual;

pub use dual::Dual;
#[cfg(feature = "num-dual")]
pub use num_dual::NumDual;

/// A real number, or several that are computed at once.
///
/// The default is zero. Elementary functions have the names and meanings of std's methods on `f64`.
///
/// ```
/// use newton_euler::Scalar;
///
/// /// sin x / x, for numbers of any kind.
/// fn sinc<T: Scalar>(x: T) -> T {
///     T::select(x.equal(T::default()), x.constant(1.0, 1.0), x.sin() / x)
/// }
///
/// assert_eq!(sinc(0.0_f64), 1.0);
/// assert_eq!(sinc(1e-9_f32), 1.0);
/// ```
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// The result of a comparison: `bool`, or one for each number.
    type Truth: Copy
        + BitAnd<Output = Self::Truth>
        + BitOr<Output = Self::Truth>
        + Not<Output = Self::Truth>;

    /// The distance from one to the next number.
    const EPSILON: f64;

    /// The count of numbers.
    const LANES: usize;

    /// A constant, given in double and in single precision. `self` may be any value and is not
    /// read: it is there because a number in a register chosen at run time cannot be made from
    /// nothing.
    #[must_use]
    fn constant(self, double: f64, single: f32) -> Self;

    /// One of the numbers.
    #[must_use]
    fn lane(self, index: usize) -> f64;

    /// `self < other`
    #[must_use]
    fn less(self, other: Self) -> Self::Truth;

    /// `self <= other`
    #[must_use]
    fn less_or_equal(self, other: Self) -> Self::Truth;

    /// `self == other`
    #[must_use]
    fn equal(self, other: Self) -> Self::Truth;

    /// `if truth { first } else { second }`; both values are computed.
    #[must_use]
    fn select(truth: Self::Truth, first: Self, second: Self) -> Self;

    /// The truth of all numbers if it is the same, otherwise none.
    #[must_use]
    fn agreed(truth: Self::Truth) -> Option<bool>;

    /// A rate times the slope of a function: zero where the rate is zero, even if the slope is
    /// infinite.
    #[must_use]
    #[cfg_attr(not(unoptimized), inline(always))]
    fn along(self, slope: Self) -> Self {
        let zero = self.constant(0.0, 0.0);
        Self::select(self.equal(zero), zero, self * slope)
    }

    /// Sine.
    #[must_use]
    fn sin(self) -> Self;
    /// Cosine.
    #[must_use]
    fn cos(self) -> Self;
    /// Sine and cosine.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);
    /// Tangent.
    #[must_use]
    fn tan(self) -> Self;
    /// Inverse sine.
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine.
    #[must_use]
    fn acos(self) -> Self;
    /// Inverse tangent.
    #[must_use]
    fn atan(self) -> Self;
    /// The angle of the point (other, self) from the first axis, in (-π, π].
    #[must_use]
    fn atan2(self, other: Self) -> Self;
    /// Hyperbolic sine.
    #[must_use]
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    #[must_use]
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;
    /// Exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// Power.
    #[must_use]
    fn powf(self, exponent: Self) -> Self;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Cube root.
    #[must_use]
    fn cbrt(self) -> Self;
    /// `√(self² + other²)` without overflow.
    #[must_use]
    fn hypot(self, other: Self) -> Self;
    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// 1 from +0 on, -1 from -0 down, NaN of NaN.
    #[must_use]
    fn signum(self) -> Self;
    /// The largest integer not above.
    #[must_use]
    fn floor(self) -> Self;
    /// The smallest integer not below.
    #[must_use]
    fn ceil(self) -> Self;
    /// The smaller; of a number and NaN, the number.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The larger; of a number and NaN, the number.
    #[must_use]
    fn max(self, other: Self) -> Self;
}

/// A constant, rounded to the precision of a scalar.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn number<T: Scalar>(like: T, value: f64) -> T {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the nearest in single precision"
    )]
    like.constant(value, value as f32)
}

/// The values of one of two branches; if the numbers do not agree, both are computed and selected
/// number by number.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn either<T: Scalar, const N: usize>(
    truth: T::Truth,
    first: impl Fn() -> [T; N],
    second: impl Fn() -> [T; N],
) -> [T; N] {
    match T::agreed(truth) {
        Some(true) => first(),
        Some(false) => second(),
        None => {
            let (first, second) = (first(), second());
            core::array::from_fn(|i| T::select(truth, first[i], second[i]))
        }
    }
}
