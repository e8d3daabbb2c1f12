//! Integers of any size, as far as means and variances need them.

use alloc::vec::Vec;

/// A nonnegative integer, by its digits of 32 bits, least significant first.
#[derive(Clone, Debug)]
pub(super) struct Whole(Vec<u32>);

impl From<u64> for Whole {
    fn from(number: u64) -> Self {
        let (low, high) = split(number);
        Self(alloc::vec![low, split(high).0])
    }
}

impl Whole {
    pub(super) fn new(digits: Vec<u32>) -> Self {
        Self(digits)
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut product = alloc::vec![0_u32; self.0.len() + other.0.len()];
        for (place, digit) in self.0.iter().enumerate() {
            let mut carried = 0;
            for (sum, other) in product[place..].iter_mut().zip(other.0.iter().chain([&0])) {
                let next = u64::from(*digit) * u64::from(*other) + u64::from(*sum) + carried;
                (*sum, carried) = split(next);
            }
        }
        Self(product)
    }

    /// The difference from a number; `None` if that is larger.
    pub(super) fn minus(&self, other: &Self) -> Option<Self> {
        let at = |number: &Self, place: usize| i64::from(number.0.get(place).copied().unwrap_or(0));
        let mut borrowed = 0;
        let digits = (0..self.0.len().max(other.0.len())).map(|place| {
            let next = at(self, place) - at(other, place) - borrowed;
            borrowed = i64::from(next < 0);
            split(next.rem_euclid(1 << 32).unsigned_abs()).0
        });
        let digits = digits.collect();
        (borrowed == 0).then_some(Self(digits))
    }

    /// The quotient by a nonzero number, times 2³², with a sticky last digit: one if there is a
    /// remainder, zero otherwise. It therefore rounds as the exact quotient does, also after
    /// another division.
    pub(super) fn over(mut self, divisor: u64) -> Self {
        let mut rest = 0_u128;
        for digit in self.0.iter_mut().rev() {
            rest = (rest << 32) | u128::from(*digit);
            *digit = u32::try_from(rest / u128::from(divisor)).unwrap_or(u32::MAX);
            rest %= u128::from(divisor);
        }
        self.0.insert(0, u32::from(rest != 0));
        self
    }

    /// The same number times 2³² to a power.
    pub(super) fn shifted(mut self, digits: usize) -> Self {
        self.0.splice(0..0, core::iter::repeat_n(0, digits));
        self
    }

    /// The nearest double to the number times a power of two; ties go to even.
    pub(super) fn rounded(&self, power: i32) -> f64 {
        let Some(last) = self.0.iter().rposition(|digit| *digit != 0) else {
            return 0.0;
        };
        let bits = 32 * last + 32 - self.0[last].leading_zeros() as usize;
        // the bits that a double of this size holds
        let exponent = i32::try_from(bits)
            .unwrap_or(i32::MAX)
            .saturating_add(power);
        if exponent < -1074 {
            return 0.0;
        }
        let held = usize::try_from((exponent + 1074).clamp(0, 53)).unwrap_or(0);
        let dropped = bits - held.min(bits);
        let bit = |place: usize| {
            let digit = self.0.get(place / 32).copied().unwrap_or(0);
            u64::from((digit >> (place % 32)) & 1)
        };
        let mantissa = (dropped..bits)
            .rev()
            .fold(0, |mantissa, place| 2 * mantissa + bit(place));
        let is_half = dropped > 0 && bit(dropped - 1) == 1;
        let is_more = is_half && (0..dropped - 1).any(|place| bit(place) == 1);
        let up = u64::from(is_half && (is_more || mantissa % 2 == 1));
        let dropped = i32::try_from(dropped).unwrap_or(i32::MAX);
        scaled(mantissa + up, dropped.saturating_add(power))
    }
}

/// The digit, and the carry.
#[expect(clippy::cast_possible_truncation, reason = "the rest is carried")]
fn split(number: u64) -> (u32, u64) {
    (number as u32, number >> 32)
}

/// An integer of at most 53 bits times a power of two; the result is a double, or too large for
/// one.
#[expect(clippy::cast_precision_loss, reason = "it has at most 53 bits")]
fn scaled(integer: u64, power: i32) -> f64 {
    libm::scalbn(integer as f64, power)
}
