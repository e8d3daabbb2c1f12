//! Values with error bounds.

use dashu_float::round::mode::HalfEven;
use dashu_int::ops::BitTest;
use dashu_ratio::RBig;

use super::float::Float;
use super::function::Function;

/// The exponent of the error of a rational number, which has none.
pub(in crate::symbolic) const NONE: isize = isize::MIN / 4;

/// A value, and the exponent of a power of two that bounds its error.
#[derive(Clone, Debug)]
pub(in crate::symbolic) struct Ball {
    pub value: RBig,
    pub error: isize,
}

impl Ball {
    pub fn rounded(value: &RBig, error: isize, bits: usize) -> Self {
        let value = value.to_float::<HalfEven, 2>(bits).value();
        let value = RBig::try_from(value).unwrap_or(RBig::ZERO);
        let error = error.max(size(&value) - bits.cast_signed() + 1) + 1;
        Self { value, error }
    }

    /// The result of a function that is accurate to the last bit or two.
    pub fn of_float(value: Float, error: isize, bits: usize) -> Option<Self> {
        let value = RBig::try_from(value).ok()?;
        let error = error.max(size(&value) - bits.cast_signed() + 1) + 1;
        Some(Self { value, error })
    }

    pub fn sum(a: &Self, b: &Self) -> Self {
        Self {
            value: &a.value + &b.value,
            error: a.error.max(b.error) + 1,
        }
    }

    pub fn product(a: &Self, b: &Self) -> Self {
        let of_a = a.error + size(&b.value) + 1;
        let of_b = b.error + size(&a.value) + 1;
        Self {
            value: &a.value * &b.value,
            error: of_a.max(of_b).max(a.error + b.error) + 2,
        }
    }

    /// The quotient; `None` unless the divisor is certainly nonzero.
    pub fn quotient(a: &Self, b: &Self) -> Option<Self> {
        if b.bits() < 3 {
            return None;
        }
        let (value, least) = (&a.value / &b.value, size(&b.value) - 2);
        let error = a.error.max(size(&value) + 1 + b.error) + 1 - least;
        Some(Self { value, error })
    }

    /// The number of correct bits of the value.
    pub fn bits(&self) -> isize {
        if self.value.is_zero() {
            isize::MIN
        } else {
            size(&self.value) - self.error
        }
    }

    pub fn may_be_zero(&self) -> bool {
        self.bits() < 3
    }

    /// The value of a function. Its slope gives the error.
    pub fn apply(&self, function: Function, bits: usize) -> Option<Self> {
        let x = self.value.to_float(bits).value();
        let is_near = self.bits() > 3;
        let (value, error) = match function {
            Function::Sin => (x.sin(), self.error),
            Function::Cos => (x.cos(), self.error),
            Function::Atan => (x.atan(), self.error),
            Function::Exp => {
                let value = (self.error < 0).then(|| x.exp())?;
                let slope = size(&RBig::try_from(value.clone()).ok()?) + 1;
                (value, self.error + slope + 1)
            }
            Function::Ln => {
                let value = (is_near && self.value > RBig::ZERO).then(|| x.ln())?;
                (value, self.error - size(&self.value) + 3)
            }
            Function::Sqrt => {
                let value = (is_near && self.value > RBig::ZERO).then(|| x.sqrt())?;
                (value, self.error - size(&self.value).div_euclid(2) + 2)
            }
            Function::Cbrt => {
                let value = is_near.then(|| x.nth_root(3))?;
                (value, self.error - 2 * size(&self.value).div_euclid(3) + 2)
            }
            _ => return None,
        };
        Self::of_float(value, error, bits)
    }
}

/// The exponent of two of a number, to within one.
pub(in crate::symbolic) fn size(value: &RBig) -> isize {
    value.numerator().bit_len().cast_signed() - value.denominator().bit_len().cast_signed()
}
