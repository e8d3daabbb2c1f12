//! Numbers at sampled states, of which nothing is known but their values: a sum that has cancelled to
//! within their precision is zero there.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::function::Function;
use super::number::{Kind, Number, PRECISION};

/// Bits that survive the cancellation of two rounded numbers before the rest counts as zero.
const SIGNIFICANT: usize = 200;

impl Number {
    pub(super) fn rounded(value: RBig) -> Self {
        let kind = Kind::Rounded;
        Self { value, kind }
    }

    /// Nothing but its value is known of it from here on.
    pub(super) fn sampled(&self) -> Self {
        match self.kind {
            Kind::Irrational(_) => Self::rounded(self.value.clone()),
            Kind::Rational | Kind::Rounded => self.clone(),
        }
    }

    pub(super) fn add_rounded(self, other: Self) -> Self {
        let scale = Self::rounded(self.value.clone());
        let sum = Self::rounded(self.value + other.value).condensed();
        let is_far = || sum.exponent() > scale.exponent() - SIGNIFICANT.cast_signed() + 2;
        if sum.is_zero() || is_far() || sum.abs() >= noise() * scale.abs() {
            return sum;
        }
        Self::zero()
    }

    /// The value of a function, or `None` outside its domain or the range of doubles.
    pub(super) fn apply_sampled(function: Function, arguments: &[Self]) -> Option<Self> {
        let first = arguments.first()?;
        let second = || arguments.get(1);
        let x = first.to_float(PRECISION);
        let is_within_one = first.abs() <= Self::one();
        let value = match function {
            Function::Sqrt => return first.root_sampled(2),
            Function::Cbrt if first.is_negative() => {
                return Some(-(-first.clone()).root_sampled(3)?);
            }
            Function::Cbrt => return first.root_sampled(3),
            Function::Hypot => {
                let second = second()?;
                let square = first.clone() * first.clone() + second.clone() * second.clone();
                return square.root_sampled(2);
            }
            _ if first.is_trivial(function) => return Self::apply(function, arguments),
            Function::Exp => return first.exp_sampled(),
            Function::Ln => first.is_positive().then(|| x.ln()),
            Function::Sin => Some(x.sin()),
            Function::Cos => Some(x.cos()),
            Function::Tan => Some(x.tan()),
            Function::Asin => is_within_one.then(|| x.asin()),
            Function::Acos => is_within_one.then(|| x.acos()),
            Function::Atan => Some(x.atan()),
            Function::Atan2 if first.is_zero() && second()?.is_zero() => return Some(Self::zero()),
            Function::Atan2 => Some(x.atan2(&second()?.to_float(PRECISION))),
            Function::Powf if second()?.to_integer().is_some() || !first.is_positive() => {
                return Self::apply(function, arguments);
            }
            Function::Powf => {
                let logarithm = Self::from_float(x.ln())?;
                return (logarithm * second()?.clone()).exp_sampled();
            }
            Function::Sinh | Function::Cosh | Function::Tanh => {
                let grown = first.exp_sampled()?;
                let decayed = Self::one() / grown.clone();
                let (sinh, cosh) = (grown.clone() - decayed.clone(), grown + decayed);
                return Some(match function {
                    Function::Sinh => sinh / Self::integer(2),
                    Function::Cosh => cosh / Self::integer(2),
                    _ => sinh / cosh,
                });
            }
            // those of exact steps and choices
            _ => return Self::apply(function, arguments),
        }?;
        let value = Self::from_float(value)?;
        let vanishes = first.is_rounded()
            && matches!(function, Function::Sin | Function::Cos)
            && value.abs() < noise();
        Some(if vanishes { Self::zero() } else { value })
    }

    /// Whether a function of one argument is rational there.
    fn is_trivial(&self, function: Function) -> bool {
        match function {
            Function::Ln | Function::Acos => self.is_one(),
            Function::Atan2 | Function::Powf | Function::Min | Function::Max => false,
            _ => self.is_zero(),
        }
    }

    fn root_sampled(&self, degree: usize) -> Option<Self> {
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
        self.exact_root(degree).or_else(|| Self::from_float(root))
    }

    /// `e^x`, refused far beyond the range of doubles before anything is built.
    fn exp_sampled(&self) -> Option<Self> {
        self.has_exponential()
            .then(|| Self::from_float(self.to_float(PRECISION).exp()))?
    }
}

fn noise() -> Number {
    Number::rounded(RBig::from_parts(IBig::ONE, UBig::ONE << SIGNIFICANT))
}
