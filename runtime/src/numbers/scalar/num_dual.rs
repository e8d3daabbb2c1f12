//! The numbers of the crate `num-dual`.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_dual::DualNum;

use super::Scalar;
use crate::numbers::math;

/// A number of the crate `num-dual` as a [`Scalar`]: derivatives of first, second and third order.
///
/// Values and derivatives are those of that crate, so they depend on the platform's library. At a
/// kink of a function, the derivative is that of the branch of the value. Where a slope is
/// infinite, as for the square root of zero, derivatives are NaN; [`Dual`](super::Dual) gives zero
/// there if the number does not change.
///
/// ```
/// use newton_euler::scalar::NumDual;
/// use newton_euler::{prelude::*, state::generic};
/// use num_dual::Dual2_64;
///
/// rigid_body!(Pendulum::<T> {
///     motion: pivot(tip),
///     mass: 2[kg],
///     inertia: 0.01[kg * m ^ 2],
///     points: [tip = (0, 0.5[m])],
///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
/// });
///
/// // the second derivative of the acceleration with respect to the angle
/// let state = generic::Hinge {
///     angle: NumDual(Dual2_64::from_re(0.3).derivative()),
///     angular_velocity: NumDual::default(),
/// };
/// let pendulum = Pendulum::<NumDual<Dual2_64>>::default();
/// let acceleration = pendulum.acceleration(NumDual::default(), &state, &()).0;
/// assert!((acceleration.v2 + acceleration.re).abs() < 1e-13, "a sine: minus itself");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumDual<D>(pub D);

/// The numbers of that crate that can be numbers of this one.
pub trait Number: DualNum<Primitive = f64> + Copy + Send + Sync {}

impl<D: DualNum<Primitive = f64> + Copy + Send + Sync> Number for D {}

impl<D: Number> NumDual<D> {
    fn number(number: f64) -> Self {
        Self(D::from(number))
    }

    /// A function of its value that is constant between jumps.
    fn stepped(self, function: impl Fn(f64) -> f64) -> Self {
        Self::number(function(self.0.re()))
    }
}

impl<D: Number> Default for NumDual<D> {
    fn default() -> Self {
        Self::number(0.0)
    }
}

/// Operators.
macro_rules! operators {
    ($($operator:ident $method:ident, $assign:ident $assign_method:ident, $symbol:tt;)*) => {$(
        impl<D: Number> $operator for NumDual<D> {
            type Output = Self;

            #[cfg_attr(not(unoptimized), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $symbol other.0)
            }
        }

        impl<D: Number> $assign for NumDual<D> {
            #[cfg_attr(not(unoptimized), inline(always))]
            fn $assign_method(&mut self, other: Self) {
                *self = *self $symbol other;
            }
        }
    )*};
}

operators! {
    Add add, AddAssign add_assign, +;
    Sub sub, SubAssign sub_assign, -;
    Mul mul, MulAssign mul_assign, *;
    Div div, DivAssign div_assign, /;
}

impl<D: Number> Neg for NumDual<D> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Functions by their names in that crate.
macro_rules! functions {
    ($($name:ident)*) => {$(
        fn $name(self) -> Self {
            Self(self.0.$name())
        }
    )*};
}

impl<D: Number> Scalar for NumDual<D> {
    type Truth = bool;
    const EPSILON: f64 = f64::EPSILON;
    const LANES: usize = 1;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn constant(self, double: f64, _: f32) -> Self {
        Self::number(double)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn lane(self, _: usize) -> f64 {
        self.0.re()
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn less(self, other: Self) -> bool {
        self.0.re() < other.0.re()
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn less_or_equal(self, other: Self) -> bool {
        self.0.re() <= other.0.re()
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    #[allow(clippy::float_cmp)]
    fn equal(self, other: Self) -> bool {
        self.0.re() == other.0.re()
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn agreed(truth: bool) -> Option<bool> {
        Some(truth)
    }

    functions! { sin cos tan asin acos atan sinh cosh tanh exp ln sqrt cbrt }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }

    fn atan2(self, other: Self) -> Self {
        let (y, x) = (self.0.re(), other.0.re());
        if y.abs() <= x.abs() {
            return Self(DualNum::atan2(&self.0, other.0));
        }
        // by the quotient that is finite
        let right = Self::number(core::f64::consts::FRAC_PI_2.copysign(y));
        right - Self((other.0 / self.0).atan())
    }

    /// The derivative by the exponent is omitted if the base is not positive.
    fn powf(self, exponent: Self) -> Self {
        if self.0.re() > 0.0 {
            Self(self.0.powd(exponent.0))
        } else {
            Self(DualNum::powf(&self.0, exponent.0.re()))
        }
    }

    fn hypot(self, other: Self) -> Self {
        let size = math::max(self.0.re().abs(), other.0.re().abs());
        if size == 0.0 || !size.is_finite() {
            return Self((self.0 * self.0 + other.0 * other.0).sqrt());
        }
        let (x, y) = (self.0 / size, other.0 / size);
        Self((x * x + y * y).sqrt() * size)
    }

    fn abs(self) -> Self {
        if self.0.re().is_sign_negative() {
            -self
        } else {
            self
        }
    }

    fn signum(self) -> Self {
        self.stepped(math::signum)
    }

    fn floor(self) -> Self {
        self.stepped(math::floor)
    }

    fn ceil(self) -> Self {
        self.stepped(math::ceil)
    }

    fn min(self, other: Self) -> Self {
        let value = math::min(self.0.re(), other.0.re());
        Self::select(value.to_bits() == self.0.re().to_bits(), self, other)
    }

    fn max(self, other: Self) -> Self {
        let value = math::max(self.0.re(), other.0.re());
        Self::select(value.to_bits() == self.0.re().to_bits(), self, other)
    }
}
