//! Scalars that remember the sizes of the terms of which they are sums.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::description::expression::{Binary, Unary};
use crate::wide::Wide;

/// Below this fraction of its size, a difference decides nothing.
pub const NEAR: f64 = 1e-11;

/// Of what has canceled in a number that is known, this much is left to its size, so that a
/// tolerance of 1e-20 is above the rounding of 106 bits.
const CANCELED: f64 = 1e-9;

/// A number and its size: that of the largest term that a sum of products has, written out. A rounding somewhere on the way
/// to it is a unit in the last place of that, at most.
///
/// What is made of literals alone is known at compile time: to all others it has its own size, whatever cancels in it,
/// but for the rounding of 106 bits.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    pub value: Wide,
    pub size: f64,
    pub known: bool,
}

impl Number {
    pub const ZERO: Self = Self::known(Wide::ZERO);
    pub const ONE: Self = Self::known(Wide::ONE);

    pub const fn known(value: Wide) -> Self {
        Self {
            value,
            size: value.high.abs(),
            known: true,
        }
    }

    /// Given at run time.
    pub fn given(value: f64) -> Self {
        Self::exactly(value.into())
    }

    /// The same of a number that is longer.
    pub fn exactly(value: Wide) -> Self {
        Self {
            known: false,
            ..Self::known(value)
        }
    }

    /// Made of others, all of them known or not.
    pub fn made(value: Wide, size: f64, known: bool) -> Self {
        let least = value.high.abs();
        // a known number without a slope is what it is
        let is_lost = known && !size.is_finite();
        Self {
            value,
            size: if is_lost { least } else { size.max(least) },
            known,
        }
    }

    /// Its size to what is not known.
    pub fn span(self) -> f64 {
        if self.known {
            self.value.high.abs().max(CANCELED * self.size)
        } else {
            self.size
        }
    }

    /// Both as known numbers, or both as others.
    fn beside(self, other: Self) -> (Self, Self) {
        let known = self.known && other.known;
        let seen = |number: Self| Self {
            size: if known { number.size } else { number.span() },
            known,
            ..number
        };
        (seen(self), seen(other))
    }

    pub fn float(self) -> f64 {
        self.value.high
    }

    pub fn squared(self) -> Self {
        self * self
    }

    pub fn powi(self, n: i32) -> Self {
        let value = self.value.powi(n);
        // of a sum, the terms of the power are those of its factors
        let size = if n < 0 {
            self.slope(value, f64::from(n) * value.high / self.float())
        } else {
            self.size.powi(n)
        };
        Self::made(value, size, self.known)
    }

    /// What a unit in the last place of this number changes in a function of it, in the same units.
    fn slope(self, value: Wide, slope: f64) -> f64 {
        value.high.abs().max(slope.abs() * self.size)
    }

    pub fn apply(self, function: Unary) -> Self {
        let (x, one) = (self.value, Wide::ONE);
        let v = x.high;
        let (value, slope) = match function {
            Unary::Sqrt => {
                let root = x.sqrt();
                (root, 0.5 / root.high)
            }
            Unary::Cbrt => {
                let root = x.cbrt();
                (root, 1.0 / (3.0 * root.high.powi(2)))
            }
            Unary::Exp => (x.exp(), x.exp().high),
            Unary::Ln => (x.ln(), 1.0 / v),
            Unary::Sin => (x.sin_cos().0, v.cos()),
            Unary::Cos => (x.sin_cos().1, v.sin()),
            Unary::Tan => {
                let (sine, cosine) = x.sin_cos();
                (sine / cosine, 1.0 / cosine.high.powi(2))
            }
            Unary::Asin => {
                let root = (one - x * x).sqrt();
                (x.atan2(root), 1.0 / root.high)
            }
            Unary::Acos => {
                let root = (one - x * x).sqrt();
                (root.atan2(x), 1.0 / root.high)
            }
            Unary::Atan => (x.atan2(one), 1.0 / (1.0 + v * v)),
            Unary::Sinh => (x.sinh(), x.cosh().high),
            Unary::Cosh => (x.cosh(), x.sinh().high),
            Unary::Tanh => {
                let value = x.tanh();
                (value, (one - value * value).high)
            }
            Unary::Abs => (x.abs(), 1.0),
            Unary::Signum => (v.signum().into(), 0.0),
            Unary::Floor => (x.floor(), 0.0),
            Unary::Ceil => (-(-x).floor(), 0.0),
            Unary::Recip => return Self::ONE / self,
        };
        Self::made(value, self.slope(value, slope), self.known)
    }

    pub fn combine(self, function: Binary, other: Self) -> Self {
        let (a, b) = self.beside(other);
        let (x, y, known) = (a.value, b.value, a.known);
        match function {
            Binary::Hypot => (a.squared() + b.squared()).apply_root(a.size.max(b.size)),
            Binary::Min | Binary::Max => {
                let is_first = (x < y) == (function == Binary::Min);
                let chosen = if is_first { self } else { other };
                // where they are nearly equal, rounding may choose
                let size = a.size.max(b.size);
                if (x - y).high.abs() > NEAR * size {
                    return chosen;
                }
                Self::made(chosen.value, size, known)
            }
            Binary::Atan2 => {
                let value = x.atan2(y);
                let radius = (x * x + y * y).sqrt().high;
                Self::made(value, a.size.max(b.size) / radius, known)
            }
            Binary::Powf => {
                let value = (y * x.ln()).exp();
                let of_base = y.high * value.high / x.high * a.size;
                let of_power = x.ln().high * value.high * b.size;
                Self::made(value, of_base.abs().max(of_power.abs()), known)
            }
        }
    }

    /// The root of a sum of squares of numbers of this size: a length, which changes no more than they do.
    pub fn apply_root(self, size: f64) -> Self {
        Self::made(self.value.sqrt(), size, self.known)
    }
}

/// Of sizes: zero only if one of them is.
pub fn product(a: f64, b: f64) -> f64 {
    let is_zero = a == 0.0 || b == 0.0;
    (a * b).max(if is_zero { 0.0 } else { f64::MIN_POSITIVE })
}

impl Neg for Number {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl Add for Number {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (a, b) = self.beside(other);
        Self::made(a.value + b.value, a.size.max(b.size), a.known)
    }
}

impl Sub for Number {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Number {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = self.beside(other);
        Self::made(a.value * b.value, product(a.size, b.size), a.known)
    }
}

impl Div for Number {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let (a, b) = self.beside(other);
        let divisor = b.float().abs();
        let size = a.size / divisor * (b.size / divisor);
        Self::made(a.value / b.value, size, a.known)
    }
}
