//! Sums without rounding.

#[cfg(feature = "serde")]
use alloc::vec::Vec;

use super::whole::Whole;

/// A sum of integers times powers of two, in digits of 32 bits (U. Kulisch, "Computer arithmetic
/// and validity", 2013).
///
/// Digits are signed and may exceed 32 bits, so that carries can be deferred.
#[derive(Clone, Debug)]
pub(super) struct Digits<const N: usize> {
    digits: [i64; N],
    /// The number of additions since the last propagation of carries.
    waiting: u32,
}

/// The additions that a digit has room for.
const ROOM: u32 = 1 << 30;

impl<const N: usize> Digits<N> {
    pub(super) const ZERO: Self = Self {
        digits: [0; N],
        waiting: 0,
    };

    /// Adds an integer times a power of two, or subtracts it.
    #[inline]
    pub(super) fn add(&mut self, integer: u128, power: usize, is_negative: bool) {
        if self.waiting == ROOM {
            self.carry();
        }
        self.waiting += 1;
        let (place, shift) = (power / 32, power % 32);
        // in two halves, so that no bits are shifted beyond 128
        let low = (integer & u128::from(u64::MAX)) << shift;
        let high = (integer >> 64) << shift;
        for (offset, part) in [(0, low), (2, high)] {
            for k in 0..3 {
                let digit = i64::from(((part >> (32 * k)) & 0xffff_ffff) as u32);
                let Some(place) = self.digits.get_mut(place + offset + k) else {
                    continue;
                };
                *place += if is_negative { -digit } else { digit };
            }
        }
    }

    /// Adds another sum.
    pub(super) fn merge(&mut self, other: &Self) {
        let other = other.canonical();
        self.carry();
        for (own, other) in self.digits.iter_mut().zip(other.digits) {
            *own += other;
        }
        self.carry();
    }

    /// The same sum with carries propagated: all digits but the last have 32 bits and are not
    /// negative. This representation is unique.
    pub(super) fn canonical(&self) -> Self {
        let mut canonical = self.clone();
        canonical.carry();
        canonical
    }

    fn carry(&mut self) {
        let mut carried = 0;
        let last = N - 1;
        for (place, digit) in self.digits.iter_mut().enumerate() {
            *digit += carried;
            if place < last {
                carried = *digit >> 32;
                *digit &= 0xffff_ffff;
            }
        }
        self.waiting = 0;
    }

    /// Whether it is negative, and its size.
    pub(super) fn whole(&self) -> (bool, Whole) {
        let canonical = self.canonical();
        let is_negative = canonical.digits[N - 1] < 0;
        let mut size = if is_negative {
            let mut opposite = canonical;
            for digit in &mut opposite.digits {
                *digit = -*digit;
            }
            opposite.canonical()
        } else {
            canonical
        };
        let last = core::mem::take(&mut size.digits[N - 1]);
        let digits = size.digits[..N - 1].iter().map(|digit| low(*digit));
        let digits = digits.chain([low(last), low(last >> 32)]);
        (is_negative, Whole::new(digits.collect()))
    }

    /// The digits of a canonical sum.
    #[cfg(feature = "serde")]
    pub(super) fn to_list(&self) -> Vec<i64> {
        self.canonical().digits.to_vec()
    }

    /// The sum with these digits, if they are canonical.
    #[cfg(feature = "serde")]
    pub(super) fn from_list(digits: &[i64]) -> Option<Self> {
        let digits: [i64; N] = digits.try_into().ok()?;
        let in_range = |digit: &i64| (0..=0xffff_ffff).contains(digit);
        digits[..N - 1]
            .iter()
            .all(in_range)
            .then_some(Self { digits, waiting: 0 })
    }
}

impl<const N: usize> PartialEq for Digits<N> {
    fn eq(&self, other: &Self) -> bool {
        self.canonical().digits == other.canonical().digits
    }
}

/// The last 32 bits.
#[expect(clippy::cast_sign_loss, reason = "the rest is in the next digit")]
fn low(digit: i64) -> u32 {
    (digit & 0xffff_ffff) as u32
}
