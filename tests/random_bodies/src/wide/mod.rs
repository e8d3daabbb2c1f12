//! Numbers of 106 bits: sums of two doubles, of which the second is within half a unit in the last
//! place of the first.
//!
//! T. J. Dekker, Numerische Mathematik 18 (1971) 224; M. Joldes, J.-M. Muller, V. Popescu, ACM TOMS
//! 44 (2017) 15res. Of the crates with such numbers, `twofloat` 0.8 divides to 53 bits and has an
//! exponential with 11 digits, and `qd` 0.8 has no sine. `functions` has what they lack.

use std::cmp::Ordering;
use std::iter::Sum;
use std::ops::{Add, Div, Mul, Neg, Sub};

mod functions;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wide {
    pub high: f64,
    pub low: f64,
}

impl Wide {
    pub const ZERO: Self = Self::new(0.0, 0.0);
    pub const ONE: Self = Self::new(1.0, 0.0);
    pub const PI: Self = Self::new(std::f64::consts::PI, 1.224_646_799_147_353_2e-16);
    pub const LN_2: Self = Self::new(std::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);

    pub const fn new(high: f64, low: f64) -> Self {
        Self { high, low }
    }

    /// The exact sum of two doubles.
    #[inline]
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        Self::new(high, (a - (high - of_b)) + (b - of_b))
    }

    /// The same if the first is not the smaller.
    #[inline]
    fn ordered(a: f64, b: f64) -> Self {
        let high = a + b;
        Self::new(high, b - (high - a))
    }

    /// The exact product of two doubles.
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self::new(high, a.mul_add(b, -high))
    }

    /// Zero of zero.
    pub fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::ZERO;
        }
        let rest = self - Self::product(root, root);
        Self::ordered(root, rest.high / (2.0 * root))
    }

    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    pub fn powi(self, n: i32) -> Self {
        let power = (0..n.abs()).fold(Self::ONE, |power, _| power * self);
        if n < 0 { Self::ONE / power } else { power }
    }

    #[allow(clippy::float_cmp, reason = "whole numbers are exact")]
    pub fn floor(self) -> Self {
        let high = self.high.floor();
        if high == self.high {
            Self::ordered(high, self.low.floor())
        } else {
            high.into()
        }
    }
}

impl From<f64> for Wide {
    #[inline]
    fn from(high: f64) -> Self {
        Self::new(high, 0.0)
    }
}

impl PartialOrd for Wide {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let high = self.high.partial_cmp(&other.high)?;
        Some(high.then(self.low.partial_cmp(&other.low)?))
    }
}

impl Neg for Wide {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

impl Add for Wide {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let sum = Self::ordered(high.high, high.low + low.high);
        Self::ordered(sum.high, sum.low + low.low)
    }
}

impl Sub for Wide {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let rest = self.high * other.low + self.low * other.high;
        Self::ordered(product.high, product.low + rest)
    }
}

impl Mul<f64> for Wide {
    type Output = Self;

    #[inline]
    fn mul(self, other: f64) -> Self {
        let product = Self::product(self.high, other);
        Self::ordered(product.high, product.low + self.low * other)
    }
}

impl Div for Wide {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self - other * quotient;
        let next = rest.high / other.high;
        Self::ordered(quotient, next)
    }
}

impl Sum for Wide {
    fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers.fold(Self::ZERO, Add::add)
    }
}
