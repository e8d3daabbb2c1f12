//! Numbers of a description: exact rationals, from the token to the single rounding.
//!
//! Sums, products and quotients of literals are exact. An irrational number carries its value, an
//! error bound, and the identities that define it ([`super::irrational`]). It counts as zero, or as
//! a rational number, only if that is proved, never because a difference is small.

use core::cell::RefCell;
use std::rc::Rc;

use dashu_int::ops::{BitTest, UnsignedAbs};
use dashu_int::{IBig, Sign, UBig};
use dashu_ratio::RBig;

use super::ball::Ball;
use super::float::Float;
use super::function::Function;
use super::residue::Residue;

/// Literals with larger decimal exponents are rejected before any number is built.
const DECIMAL_EXPONENTS: i64 = 5000;
/// Numbers with more bits are not kept at all.
const SIZE: usize = 1 << 16;

/// A rational number, or a rational number near an irrational one.
#[derive(Clone, Debug)]
pub struct Number {
    pub(in crate::symbolic) value: RBig,
    pub(in crate::symbolic) kind: Kind,
}

/// What the value of a number stands for.
#[derive(Clone, Debug)]
pub(in crate::symbolic) enum Kind {
    /// The number itself.
    Rational,
    /// A number near the value, which is defined by its [`Term`].
    Irrational(Rc<Irrational>),
}

/// What defines an irrational number beyond its value.
#[derive(Debug)]
pub(in crate::symbolic) struct Irrational {
    pub residue: Residue,
    /// The error of the value is below 2 to this power.
    pub error: isize,
    pub term: Term,
    /// The number of operations that computing it again takes.
    pub cost: usize,
    /// The values computed so far, each with its number of bits.
    pub again: RefCell<Vec<(usize, Option<Ball>)>>,
}

/// How to compute a number with more bits.
#[derive(Clone, Debug)]
pub enum Term {
    Pi,
    Sum(Number, Number),
    Product(Number, Number),
    Quotient(Number, Number),
    Value(Function, Number),
    /// There is no way: it is as accurate as it can be.
    Kept,
}

impl Number {
    pub fn zero() -> Self {
        Self::from(RBig::ZERO)
    }

    pub fn one() -> Self {
        Self::from(RBig::ONE)
    }

    pub fn integer(value: i64) -> Self {
        Self::from(RBig::from(value))
    }

    /// `numerator / denominator`; the denominator must not be zero.
    pub fn ratio(numerator: i64, denominator: u64) -> Self {
        Self::from(RBig::from_parts(
            IBig::from(numerator),
            UBig::from(denominator),
        ))
    }

    /// 10 to a small power.
    pub fn power_of_ten(exponent: i64) -> Self {
        let power =
            RBig::from(IBig::from(10).pow(usize::try_from(exponent.unsigned_abs()).unwrap_or(0)));
        Self::from(if exponent < 0 {
            RBig::ONE / power
        } else {
            power
        })
    }

    /// 2 to a small power.
    pub fn power_of_two(exponent: isize) -> Self {
        let power = RBig::from(UBig::ONE << exponent.unsigned_abs());
        Self::from(if exponent < 0 {
            RBig::ONE / power
        } else {
            power
        })
    }

    /// Reads the digits of a Rust literal: `1_000`, `1.5e-3`, `0x1F`, `0b10`, `0o17`.
    pub fn parse(digits: &str) -> Option<Self> {
        let digits = digits.replace('_', "");
        for (prefix, radix) in [("0x", 16), ("0o", 8), ("0b", 2)] {
            if let Some(rest) = digits.strip_prefix(prefix) {
                return IBig::from_str_radix(rest, radix)
                    .ok()
                    .map(|value| Self::from(RBig::from(value)));
            }
        }
        let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
            None => (digits.as_str(), 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let scale = exponent - i64::try_from(fraction.len()).ok()?;
        if scale.abs() > DECIMAL_EXPONENTS {
            return None;
        }
        let integer = IBig::from_str_radix(&format!("{whole}{fraction}"), 10).ok()?;
        Some(Self::from(RBig::from(integer)) * Self::power_of_ten(scale))
    }

    /// The exact value of a double; zero for a non-finite one.
    pub fn from_f64(value: f64) -> Self {
        Self::from(RBig::try_from(value).unwrap_or(RBig::ZERO))
    }

    pub fn is_zero(&self) -> bool {
        self.value.is_zero()
    }

    pub fn is_one(&self) -> bool {
        self.value.is_one() && !self.is_rounded()
    }

    pub fn is_negative(&self) -> bool {
        self.value.sign() == Sign::Negative
    }

    pub fn is_positive(&self) -> bool {
        self.value.sign() == Sign::Positive && !self.is_zero()
    }

    /// The number as an integer, if it is a small one.
    pub fn to_integer(&self) -> Option<i64> {
        (self.value.is_int() && !self.is_rounded())
            .then(|| i64::try_from(self.value.numerator().clone()).ok())
            .flatten()
    }

    /// Numerator and denominator, if it is a ratio of small numbers.
    pub fn to_fraction(&self) -> Option<(i64, i64)> {
        let above = i64::try_from(self.value.numerator().clone()).ok()?;
        let below = i64::try_from(self.value.denominator().clone()).ok()?;
        (!self.is_rounded()).then_some((above, below))
    }

    /// Whether its value is only an approximation.
    pub fn is_rounded(&self) -> bool {
        !matches!(self.kind, Kind::Rational)
    }

    /// Numerator and denominator modulo a prime.
    pub fn modulo(&self, prime: u128) -> [u128; 2] {
        let above = self.value.numerator();
        let rest = above.clone().unsigned_abs() % prime;
        let is_negative = rest != 0 && self.is_negative();
        [
            if is_negative { prime - rest } else { rest },
            self.value.denominator() % prime,
        ]
    }

    /// The nearest double: the single rounding of a constant. Infinite beyond the range of doubles.
    pub fn to_f64(&self) -> f64 {
        self.value.to_f64().value()
    }

    /// The nearest number of single precision; infinite beyond the range of single precision.
    pub fn to_f32(&self) -> f32 {
        self.value.to_f32().value()
    }

    /// Whether the nearest double is finite, and is zero only if the number is.
    pub fn fits_f64(&self) -> bool {
        let nearest = self.to_f64();
        nearest.is_finite() && (nearest != 0.0 || self.is_zero())
    }

    /// The root, if it is a ratio of integers.
    pub(in crate::symbolic) fn exact_root(&self, degree: usize) -> Option<Self> {
        let (numerator, denominator) = (self.value.numerator().clone(), self.value.denominator());
        let numerator = UBig::try_from(numerator).ok()?;
        let roots = (numerator.nth_root(degree), denominator.nth_root(degree));
        let is_exact = roots.0.pow(degree) == numerator && &roots.1.pow(degree) == denominator;
        (is_exact && !self.is_rounded())
            .then(|| Self::from(RBig::from_parts(roots.0.into(), roots.1)))
    }

    pub(in crate::symbolic) fn to_float(&self, bits: usize) -> Float {
        self.value.to_float(bits).value()
    }

    /// Whether the number is small enough to be kept.
    pub fn is_carried(&self) -> bool {
        self.bits() < SIZE
    }

    pub(in crate::symbolic) fn bits(&self) -> usize {
        self.value.numerator().bit_len() + self.value.denominator().bit_len()
    }
}

impl From<RBig> for Number {
    fn from(value: RBig) -> Self {
        Self {
            value,
            kind: Kind::Rational,
        }
    }
}
