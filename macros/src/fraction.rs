//! Exponents: fractions of small integers.

use core::fmt;

/// A fraction in lowest terms, with a positive denominator; both are at most [`Fraction::MOST`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fraction {
    numerator: i32,
    denominator: i32,
}

impl Fraction {
    pub const MOST: i64 = 1000;
    pub const ZERO: Self = Self::whole(0);
    pub const ONE: Self = Self::whole(1);

    /// The fraction that is a small integer.
    pub const fn whole(numerator: i32) -> Self {
        Self {
            numerator,
            denominator: 1,
        }
    }

    /// `None` for a division by zero, and if the numbers are still too large in lowest terms.
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        let (mut divisor, mut rest) = (numerator.checked_abs()?, denominator.checked_abs()?);
        while rest != 0 {
            (divisor, rest) = (rest, divisor % rest);
        }
        let divisor = if denominator < 0 { -divisor } else { divisor };
        let small = |part: i64| {
            let part = part.checked_div(divisor)?;
            let is_small = part.abs() <= Self::MOST;
            is_small.then(|| i32::try_from(part).ok())?
        };
        (denominator != 0).then_some(Self {
            numerator: small(numerator)?,
            denominator: small(denominator)?,
        })
    }

    pub fn parts(self) -> (i64, i64) {
        (self.numerator.into(), self.denominator.into())
    }

    pub fn plus(self, other: Self) -> Option<Self> {
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        Self::new(a * d + c * b, b * d)
    }

    pub fn times(self, other: Self) -> Option<Self> {
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        Self::new(a * c, b * d)
    }

    pub fn negative(self) -> Self {
        Self {
            numerator: -self.numerator,
            ..self
        }
    }

    pub fn abs(self) -> Self {
        Self {
            numerator: self.numerator.abs(),
            ..self
        }
    }

    pub fn is_positive(self) -> bool {
        self.numerator > 0
    }
}

impl fmt::Display for Fraction {
    /// `2`, `(4/3)`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.parts() {
            (numerator, 1) => write!(f, "{numerator}"),
            (numerator, denominator) => write!(f, "({numerator}/{denominator})"),
        }
    }
}
