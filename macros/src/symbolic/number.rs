//! Numbers as they stand in a description: exact rationals, from the token to the one rounding.
//!
//! Sums, products and quotients of literals are exact. Roots and transcendental functions are
//! evaluated to [`PRECISION`] bits and marked as rounded; a sum of rounded numbers that cancels to
//! within that precision is zero, so that `(PI / 2).cos()` prunes like the zero it stands for.

use core::cmp::Ordering;
use core::hash::{Hash, Hasher};
use core::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::{FBig, round::mode::HalfEven};
use dashu_int::ops::{BitTest, UnsignedAbs};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::function::Function;

/// Bits kept of a number that is not rational.
const PRECISION: usize = 256;
/// Bits that survive the cancellation of two rounded numbers before the rest counts as zero.
const SIGNIFICANT: usize = 200;
/// Decimal exponents beyond which a literal is refused before any number is built.
const DECIMAL_EXPONENTS: i64 = 5000;
/// Bits of numerator and denominator beyond which an exact number is rounded to [`PRECISION`].
const EXACT: usize = 1 << 13;
/// The same of a number that is rounded already, and what is kept of it then.
const ROUNDED: usize = 1 << 11;
const KEPT: usize = 1 << 9;
/// Bits beyond which a number is not carried at all.
const SIZE: usize = 1 << 16;

/// A binary number of so many bits.
pub(super) type Float = FBig<HalfEven, 2>;

/// An exact rational, or the rational nearest to an irrational number.
///
/// Equality, order and hash are those of the value.
#[derive(Clone, Debug)]
pub struct Number {
    value: RBig,
    rounded: bool,
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

    /// `numerator / denominator`; the denominator is not zero.
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

    pub fn pi() -> Self {
        Self::from_float(Float::pi(PRECISION)).unwrap_or_else(Self::zero)
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

    /// The value of a double, exactly; of one that is not finite, zero.
    pub fn from_f64(value: f64) -> Self {
        Self::from(RBig::try_from(value).unwrap_or(RBig::ZERO))
    }

    pub fn is_zero(&self) -> bool {
        self.value.is_zero()
    }

    pub fn is_one(&self) -> bool {
        self.value.is_one()
    }

    pub fn is_negative(&self) -> bool {
        self.value < RBig::ZERO
    }

    pub fn is_positive(&self) -> bool {
        self.value > RBig::ZERO
    }

    /// The integer that this number is, if it is a small one.
    pub fn to_integer(&self) -> Option<i64> {
        (self.value.is_int())
            .then(|| i64::try_from(self.value.numerator().clone()).ok())
            .flatten()
    }

    /// Whether it is the nearest to a number that is not rational.
    pub fn is_rounded(&self) -> bool {
        self.rounded
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

    /// The nearest double: the one rounding of a constant. Infinite beyond the range of doubles.
    pub fn to_f64(&self) -> f64 {
        self.value.to_f64().value()
    }

    /// The nearest number of single precision; infinite beyond their range.
    pub fn to_f32(&self) -> f32 {
        self.value.to_f32().value()
    }

    /// Whether the nearest double is finite, and zero only if the number is.
    pub fn fits_f64(&self) -> bool {
        let nearest = self.to_f64();
        nearest.is_finite() && (nearest != 0.0 || self.is_zero())
    }

    pub fn abs(&self) -> Self {
        if self.is_negative() {
            -self.clone()
        } else {
            self.clone()
        }
    }

    /// `None` for a division by zero.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero()).then(|| self.clone() / divisor.clone())
    }

    /// The value of a function, or `None` outside its domain or the range of doubles.
    pub fn apply(function: Function, arguments: &[Self]) -> Option<Self> {
        let first = arguments.first()?;
        match function {
            Function::Abs => Some(first.abs()),
            Function::Signum => Some(Self::integer(if first.is_negative() { -1 } else { 1 })),
            Function::Floor => Some(Self::from(RBig::from(first.value.floor()))),
            Function::Ceil => Some(Self::from(RBig::from(first.value.ceil()))),
            Function::Min => Some(first.min(arguments.get(1)?).clone()),
            Function::Max => Some(first.max(arguments.get(1)?).clone()),
            Function::Sqrt => first.root(2),
            Function::Cbrt if first.is_negative() => Some(-(-first.clone()).root(3)?),
            Function::Cbrt => first.root(3),
            Function::Hypot => {
                let second = arguments.get(1)?;
                (first.clone() * first.clone() + second.clone() * second.clone()).root(2)
            }
            Function::Powf => first.powf(arguments.get(1)?),
            _ => first.transcendental(function, arguments.get(1)),
        }
    }

    /// The exact root if there is one, else the rounded one; `None` for a negative number.
    fn root(&self, degree: usize) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        let float = self.to_float(PRECISION);
        let root = if degree == 2 {
            float.sqrt()
        } else {
            float.nth_root(degree)
        };
        let rounded = Self::from_float(root)?;
        Some(self.exact_root(degree).unwrap_or(rounded))
    }

    /// The root, if it is a ratio of whole numbers.
    pub(super) fn exact_root(&self, degree: usize) -> Option<Self> {
        let (numerator, denominator) = (self.value.numerator().clone(), self.value.denominator());
        let numerator = UBig::try_from(numerator).ok()?;
        let roots = (numerator.nth_root(degree), denominator.nth_root(degree));
        (roots.0.pow(degree) == numerator && &roots.1.pow(degree) == denominator).then(|| Self {
            value: RBig::from_parts(roots.0.into(), roots.1),
            rounded: self.rounded,
        })
    }

    fn powf(&self, exponent: &Self) -> Option<Self> {
        if exponent.is_zero() {
            return Some(Self::one());
        }
        if self.is_zero() {
            return exponent.is_positive().then(Self::zero);
        }
        if self.is_negative() {
            return None;
        }
        let logarithm = self.to_float(PRECISION).ln() * exponent.to_float(PRECISION);
        Self::exponential(&logarithm)
    }

    /// `e^x`, refused far beyond the range of doubles before anything is built.
    fn exponential(exponent: &Float) -> Option<Self> {
        let bound = Float::from(1000);
        (*exponent < bound && *exponent > -bound).then(|| Self::from_float(exponent.exp()))?
    }

    fn transcendental(&self, function: Function, second: Option<&Self>) -> Option<Self> {
        if let Some(exact) = self.trivial(function, second) {
            return Some(exact);
        }
        let x = self.to_float(PRECISION);
        let within_one = self.abs() <= Self::one();
        let value = match function {
            Function::Exp => return Self::exponential(&x),
            Function::Ln => self.is_positive().then(|| x.ln()),
            Function::Sin => Some(x.sin()),
            Function::Cos => Some(x.cos()),
            Function::Tan => Some(x.tan()),
            Function::Asin => within_one.then(|| x.asin()),
            Function::Acos => within_one.then(|| x.acos()),
            Function::Atan => Some(x.atan()),
            Function::Atan2 => Some(x.atan2(&second?.to_float(PRECISION))),
            Function::Sinh | Function::Cosh | Function::Tanh => return self.hyperbolic(function),
            _ => None,
        }?;
        let value = Self::from_float(value)?;
        // a value of order one that is as small as the rounding of its argument stands for zero
        let noise = Self::from(RBig::from_parts(IBig::ONE, UBig::ONE << SIGNIFICANT));
        let vanishes = self.rounded
            && matches!(function, Function::Sin | Function::Cos)
            && value.abs() < noise;
        Some(if vanishes { Self::zero() } else { value })
    }

    /// Arguments at which a function is rational.
    fn trivial(&self, function: Function, second: Option<&Self>) -> Option<Self> {
        match function {
            Function::Exp | Function::Cos | Function::Cosh if self.is_zero() => Some(Self::one()),
            Function::Ln | Function::Acos if self.is_one() => Some(Self::zero()),
            Function::Sin
            | Function::Tan
            | Function::Asin
            | Function::Atan
            | Function::Sinh
            | Function::Tanh
                if self.is_zero() =>
            {
                Some(Self::zero())
            }
            Function::Atan2 if self.is_zero() && !second?.is_negative() => Some(Self::zero()),
            _ => None,
        }
    }

    fn hyperbolic(&self, function: Function) -> Option<Self> {
        let grown = Self::exponential(&self.to_float(PRECISION))?;
        let decayed = Self::one() / grown.clone();
        let (sinh, cosh) = (grown.clone() - decayed.clone(), grown + decayed);
        Some(match function {
            Function::Sinh => sinh / Self::integer(2),
            Function::Cosh => cosh / Self::integer(2),
            _ => sinh / cosh,
        })
    }

    pub(super) fn to_float(&self, bits: usize) -> Float {
        self.value.to_float(bits).value()
    }

    /// Of a result of arithmetic, which is finite.
    pub(super) fn from_float_or_zero(value: Float) -> Self {
        Self::from_float(value).unwrap_or_else(Self::zero)
    }

    fn from_float(value: Float) -> Option<Self> {
        RBig::try_from(value).ok().map(|value| Self {
            value,
            rounded: true,
        })
    }

    /// Whether the number is still small enough to be carried along.
    pub fn is_carried(&self) -> bool {
        self.bits() < SIZE
    }

    fn bits(&self) -> usize {
        self.value.numerator().bit_len() + self.value.denominator().bit_len()
    }

    /// Gives up exactness where it has grown out of all proportion.
    fn condensed(self) -> Self {
        let (most, kept) = if self.rounded {
            (ROUNDED, KEPT)
        } else {
            (EXACT, PRECISION)
        };
        if self.bits() < most || !self.is_carried() {
            return self;
        }
        Self::from_float(self.to_float(kept)).unwrap_or(self)
    }

    /// A rounded result that has cancelled down to the noise of its terms is zero.
    fn snapped(self, scale: &RBig) -> Self {
        let is_far = || size(&self.value) > size(scale) - SIGNIFICANT.cast_signed() + 2;
        if !self.rounded || self.value.is_zero() || is_far() {
            return self;
        }
        let noise = RBig::from_parts(IBig::ONE, UBig::ONE << SIGNIFICANT) * magnitude(scale);
        if magnitude(&self.value) < noise {
            Self::zero()
        } else {
            self
        }
    }
}

/// The exponent of two, to one.
fn size(value: &RBig) -> isize {
    value.numerator().bit_len().cast_signed() - value.denominator().bit_len().cast_signed()
}

fn magnitude(value: &RBig) -> RBig {
    if *value < RBig::ZERO {
        -value.clone()
    } else {
        value.clone()
    }
}

impl From<RBig> for Number {
    fn from(value: RBig) -> Self {
        Self {
            value,
            rounded: false,
        }
    }
}

impl Add for Number {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let scale = self.value.clone();
        Self {
            value: self.value + other.value,
            rounded: self.rounded || other.rounded,
        }
        .condensed()
        .snapped(&scale)
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
        Self {
            value: self.value * other.value,
            rounded: self.rounded || other.rounded,
        }
        .condensed()
    }
}

impl Div for Number {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self {
            value: self.value / other.value,
            rounded: self.rounded || other.rounded,
        }
        .condensed()
    }
}

impl Neg for Number {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            rounded: self.rounded,
        }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.value.hash(state);
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> Ordering {
        self.value.cmp(&other.value)
    }
}
