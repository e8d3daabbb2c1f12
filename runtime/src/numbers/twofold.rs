//! Numbers of twice the precision, for sums that cancel and phases that grow.
//!
//! Each is the sum of two doubles, the second below half a unit in the last place of the first. T.
//! J. Dekker, A floating-point technique for extending the available precision, Numerische
//! Mathematik 18 (1971) 224; error bounds: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous
//! error bounds for basic building blocks of double-word arithmetic, ACM TOMS 44 (2017) 15res. With
//! u = 2⁻⁵³, relative errors are below 3u² for sums, 5u² for products and 10u² for quotients; where
//! doubles overflow the result is not a number.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::numbers::math;

/// The unevaluated sum of two doubles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Twofold {
    high: f64,
    low: f64,
}

impl Twofold {
    /// The exact product of two doubles (unless it underflows): from their halves, whose products
    /// are exact.
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ([a, of_a], [b, of_b]) = (halves(a), halves(b));
        let rest = ((high - a * b) - of_a * b) - a * of_b;
        Self {
            high,
            low: of_a * of_b - rest,
        }
    }

    /// The exact sum of two doubles.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        Self {
            high,
            low: (a - (high - of_b)) + (b - of_b),
        }
    }

    /// The nearest double.
    pub(crate) fn value(self) -> f64 {
        self.high
    }

    /// The square root of a nonnegative number.
    pub(crate) fn sqrt(self) -> Self {
        let root = math::sqrt(self.high);
        if root == 0.0 {
            return Self::from(root);
        }
        let rest = self - Self::product(root, root);
        Self::ordered(root, rest.high / (2.0 * root))
    }

    /// Times a power of two.
    pub(crate) fn scaled(self, exponent: i32) -> Self {
        Self {
            high: libm::scalbn(self.high, exponent),
            low: libm::scalbn(self.low, exponent),
        }
    }

    /// Sine and cosine of an angle of any size.
    pub(crate) fn sin_cos(self) -> (f64, f64) {
        let (sine, cosine) = math::sin_cos(self.high);
        let (low_sine, low_cosine) = if self.low.abs() < 1e-8 {
            (self.low, 1.0) // to the last bit
        } else {
            math::sin_cos(self.low)
        };
        (
            sine * low_cosine + cosine * low_sine,
            cosine * low_cosine - sine * low_sine,
        )
    }

    /// The exact sum of two doubles, the first not the smaller.
    fn ordered(a: f64, b: f64) -> Self {
        let high = a + b;
        Self {
            high,
            low: b - (high - a),
        }
    }
}

impl From<f64> for Twofold {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Neg for Twofold {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Add for Twofold {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let [high, low] = [
            Self::sum(self.high, other.high),
            Self::sum(self.low, other.low),
        ];
        let sum = Self::ordered(high.high, high.low + low.high);
        Self::ordered(sum.high, sum.low + low.low)
    }
}

impl Sub for Twofold {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let rest = self.high * other.low + self.low * other.high;
        Self::ordered(product.high, product.low + rest)
    }
}

impl Div for Twofold {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let rest = self - other * Self::from(quotient);
        Self::ordered(quotient, rest.high / other.high)
    }
}

/// The nearest number of 26 bits, and the remainder, of 26 bits and a sign.
fn halves(x: f64) -> [f64; 2] {
    let upper = f64::from_bits(x.to_bits().wrapping_add(1 << 26) & (u64::MAX << 27));
    [upper, x - upper]
}
