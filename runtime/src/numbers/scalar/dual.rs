//! Dual numbers: a value with its derivatives.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::Scalar;

/// A number and its derivatives with respect to N variables: exact to rounding, no differences.
///
/// `value + Σ derivatives[i] ε_i` with `ε_i ε_j = 0`. For second derivatives use
/// `Dual<Dual<f64, N>, N>`. At a kink of a function, the derivative is that of the branch
/// of the value, and zero for a `hypot` that is zero; comparisons use the values.
///
/// ```
/// use newton_euler::{Dual, Scalar, rigid_body, prelude::*};
///
/// rigid_body!(Pendulum::<T> {
///     motion: pivot(tip),
///     mass: 2[kg],
///     inertia: 0.01[kg * m ^ 2],
///     points: [tip = (0, 0.5[m])],
///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
/// });
///
/// // stiffness and damping of small motions about an angle
/// let state = newton_euler::state::generic::Hinge {
///     angle: Dual::variable(0.3, 0),
///     angular_velocity: Dual::variable(0.0, 1),
/// };
/// let acceleration =
///     Pendulum::<Dual<f64, 2>>::default().acceleration(Dual::from(0.0), &state, &());
/// let expected = -2.0 * 0.5 * 9.80665 / (0.01 + 2.0 * 0.25) * 0.3_f64.cos();
/// assert!((acceleration.derivatives[0] - expected).abs() < 1e-14);
/// assert_eq!(acceleration.derivatives[1], 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T, const N: usize> {
    /// The number.
    pub value: T,
    /// Its derivatives.
    pub derivatives: [T; N],
}

impl<T: Scalar, const N: usize> Dual<T, N> {
    /// The variable with this index, at this value: its derivative with respect to itself is one.
    ///
    /// # Panics
    /// If the index is out of range.
    #[must_use]
    pub fn variable(value: T, index: usize) -> Self {
        let mut variable = Self::from(value);
        variable.derivatives[index] = value.constant(1.0, 1.0);
        variable
    }

    /// A function of this number, from its value and its derivative.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn map(self, value: T, slope: T) -> Self {
        Self {
            value,
            derivatives: self.derivatives.map(|derivative| slope * derivative),
        }
    }

    /// A function of two numbers, from its value and its two derivatives.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn join(self, other: Self, value: T, [first, second]: [T; 2]) -> Self {
        let joined = |i: usize| first * self.derivatives[i] + second * other.derivatives[i];
        Self {
            value,
            derivatives: core::array::from_fn(joined),
        }
    }

    /// Like [`Self::map`], for a function whose slope may be infinite.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn map_steep(self, value: T, slope: T) -> Self {
        Self {
            value,
            derivatives: self.derivatives.map(|derivative| derivative.along(slope)),
        }
    }

    /// Like [`Self::join`], for a function whose slopes may be infinite.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn join_steep(self, other: Self, value: T, [first, second]: [T; 2]) -> Self {
        let joined =
            |i: usize| self.derivatives[i].along(first) + other.derivatives[i].along(second);
        Self {
            value,
            derivatives: core::array::from_fn(joined),
        }
    }

    fn one(self) -> T {
        self.value.constant(1.0, 1.0)
    }

    fn zero(self) -> T {
        self.value.constant(0.0, 0.0)
    }
}

/// A constant.
impl<T: Scalar, const N: usize> From<T> for Dual<T, N> {
    fn from(value: T) -> Self {
        Self {
            value,
            derivatives: [value.constant(0.0, 0.0); N],
        }
    }
}

impl<T: Scalar, const N: usize> Default for Dual<T, N> {
    fn default() -> Self {
        Self::from(T::default())
    }
}

impl<T: Scalar, const N: usize> Add for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            derivatives: core::array::from_fn(|i| self.derivatives[i] + other.derivatives[i]),
        }
    }
}

impl<T: Scalar, const N: usize> Sub for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            derivatives: core::array::from_fn(|i| self.derivatives[i] - other.derivatives[i]),
        }
    }
}

impl<T: Scalar, const N: usize> Mul for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn mul(self, other: Self) -> Self {
        self.join(other, self.value * other.value, [other.value, self.value])
    }
}

impl<T: Scalar, const N: usize> Div for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn div(self, other: Self) -> Self {
        let (quotient, reciprocal) = (self.value / other.value, self.one() / other.value);
        self.join(other, quotient, [reciprocal, -quotient * reciprocal])
    }
}

impl<T: Scalar, const N: usize> Neg for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            derivatives: self.derivatives.map(|derivative| -derivative),
        }
    }
}

/// The assigning operators.
macro_rules! assign {
    ($($operator:ident $method:ident $symbol:tt;)*) => {$(
        impl<T: Scalar, const N: usize> $operator for Dual<T, N> {
            #[cfg_attr(not(unoptimized), inline(always))]
            fn $method(&mut self, other: Self) {
                *self = *self $symbol other;
            }
        }
    )*};
}

assign! {
    AddAssign add_assign +;
    SubAssign sub_assign -;
    MulAssign mul_assign *;
    DivAssign div_assign /;
}

impl<T: Scalar, const N: usize> Scalar for Dual<T, N> {
    type Truth = T::Truth;
    const EPSILON: f64 = T::EPSILON;
    const LANES: usize = T::LANES;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn constant(self, double: f64, single: f32) -> Self {
        Self::from(self.value.constant(double, single))
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn lane(self, index: usize) -> f64 {
        self.value.lane(index)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn less(self, other: Self) -> T::Truth {
        self.value.less(other.value)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn less_or_equal(self, other: Self) -> T::Truth {
        self.value.less_or_equal(other.value)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn equal(self, other: Self) -> T::Truth {
        self.value.equal(other.value)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn select(truth: T::Truth, first: Self, second: Self) -> Self {
        let chosen = |i: usize| T::select(truth, first.derivatives[i], second.derivatives[i]);
        Self {
            value: T::select(truth, first.value, second.value),
            derivatives: core::array::from_fn(chosen),
        }
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn along(self, slope: Self) -> Self {
        let product = |i: usize| {
            self.derivatives[i].along(slope.value) + self.value.along(slope.derivatives[i])
        };
        Self {
            value: self.value.along(slope.value),
            derivatives: core::array::from_fn(product),
        }
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn agreed(truth: T::Truth) -> Option<bool> {
        T::agreed(truth)
    }

    fn sin(self) -> Self {
        self.sin_cos().0
    }

    fn cos(self) -> Self {
        self.sin_cos().1
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.map(sine, cosine), self.map(cosine, -sine))
    }

    fn tan(self) -> Self {
        let tangent = self.value.tan();
        self.map(tangent, self.one() + tangent * tangent)
    }

    fn asin(self) -> Self {
        let (one, x) = (self.one(), self.value);
        self.map_steep(x.asin(), one / ((one - x) * (one + x)).sqrt())
    }

    fn acos(self) -> Self {
        let (one, x) = (self.one(), self.value);
        self.map_steep(x.acos(), -one / ((one - x) * (one + x)).sqrt())
    }

    fn atan(self) -> Self {
        let (one, x) = (self.one(), self.value);
        self.map(x.atan(), one / (one + x * x))
    }

    fn atan2(self, other: Self) -> Self {
        let (y, x) = (self.value, other.value);
        // divided by the square of the distance, whose square may be out of range
        let distance = y.hypot(x);
        let slopes = [x / distance / distance, -(y / distance / distance)];
        self.join_steep(other, y.atan2(x), slopes)
    }

    fn sinh(self) -> Self {
        self.map(self.value.sinh(), self.value.cosh())
    }

    fn cosh(self) -> Self {
        self.map(self.value.cosh(), self.value.sinh())
    }

    fn tanh(self) -> Self {
        let tangent = self.value.tanh();
        let one = self.one();
        self.map(tangent, (one - tangent) * (one + tangent))
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.map(power, power)
    }

    fn ln(self) -> Self {
        self.map_steep(self.value.ln(), self.one() / self.value)
    }

    /// The derivative by a constant exponent is omitted, so that bases may be
    /// negative.
    fn powf(self, exponent: Self) -> Self {
        let (x, y) = (self.value, exponent.value);
        let power = x.powf(y);
        // a base of zero has an infinite slope or logarithm, which nothing multiplies
        let slopes = [y.along(x.powf(y - self.one())), power.along(x.ln())];
        self.join_steep(exponent, power, slopes)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.map_steep(root, self.one() / (root + root))
    }

    fn cbrt(self) -> Self {
        let root = self.value.cbrt();
        self.map_steep(
            root,
            self.one() / (root * root * self.value.constant(3.0, 3.0)),
        )
    }

    fn hypot(self, other: Self) -> Self {
        let distance = self.value.hypot(other.value);
        let is_zero = distance.equal(self.zero());
        let slope = |side: T| T::select(is_zero, self.zero(), side / distance);
        self.join_steep(other, distance, [slope(self.value), slope(other.value)])
    }

    fn abs(self) -> Self {
        self.map(self.value.abs(), self.value.signum())
    }

    fn signum(self) -> Self {
        self.map(self.value.signum(), self.zero())
    }

    fn floor(self) -> Self {
        self.map(self.value.floor(), self.zero())
    }

    fn ceil(self) -> Self {
        self.map(self.value.ceil(), self.zero())
    }

    fn min(self, other: Self) -> Self {
        let value = self.value.min(other.value);
        Self {
            value,
            ..Self::select(value.equal(self.value), self, other)
        }
    }

    fn max(self, other: Self) -> Self {
        let value = self.value.max(other.value);
        Self {
            value,
            ..Self::select(value.equal(self.value), self, other)
        }
    }
}
