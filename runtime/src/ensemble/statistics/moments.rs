//! Count, mean, variance and extremes of numbers.

use super::digits::Digits;
use super::whole::Whole;

/// Digits for a sum of 2⁶⁴ doubles, and for the sum of their squares.
const SUM: usize = 69;
const SQUARES: usize = 136;

/// Count, mean, variance and extremes of numbers, exact until the final rounding.
///
/// Infinite numbers and NaN are counted separately, and do not enter the others.
///
/// ```
/// use newton_euler::ensemble::Moments;
///
/// let moments: Moments = [1e300, 1.0, -1e300, 4.0, f64::NAN].into_iter().collect();
/// assert_eq!((moments.count(), moments.not_finite()), (4, 1));
/// assert_eq!(moments.mean(), Some(1.25));
/// assert_eq!((moments.least(), moments.greatest()), (Some(-1e300), Some(1e300)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Moments {
    pub(super) count: u64,
    pub(super) not_finite: u64,
    /// In the order of all doubles: -0 is less than 0.
    pub(super) extremes: Option<[f64; 2]>,
    /// Times 2¹⁰⁷⁴.
    pub(super) sum: Digits<SUM>,
    /// Times 2²¹⁴⁸.
    pub(super) squares: Digits<SQUARES>,
}

impl Moments {
    /// The moments of no numbers.
    #[must_use]
    pub fn new() -> Self {
        Self {
            count: 0,
            not_finite: 0,
            extremes: None,
            sum: Digits::ZERO,
            squares: Digits::ZERO,
        }
    }

    /// Adds a number.
    pub fn add(&mut self, number: f64) {
        if !number.is_finite() {
            self.not_finite += 1;
            return;
        }
        self.count += 1;
        self.widen([number; 2]);
        let bits = number.to_bits();
        // the number is an integer times 2 to the power, over 2¹⁰⁷⁴
        let (exponent, fraction) = (
            usize::from((bits >> 52) as u16 & 0x7ff),
            bits & ((1 << 52) - 1),
        );
        let (integer, power) = match exponent {
            0 => (fraction, 0),
            exponent => (fraction | 1 << 52, exponent - 1),
        };
        let integer = u128::from(integer);
        self.sum.add(integer, power, number.is_sign_negative());
        self.squares.add(integer * integer, 2 * power, false);
    }

    fn widen(&mut self, [low, high]: [f64; 2]) {
        let [least, greatest] = self.extremes.unwrap_or([low, high]);
        let least = if low.total_cmp(&least).is_lt() {
            low
        } else {
            least
        };
        let greatest = if high.total_cmp(&greatest).is_gt() {
            high
        } else {
            greatest
        };
        self.extremes = Some([least, greatest]);
    }

    /// Adds the numbers of others.
    pub fn merge(&mut self, others: &Self) {
        self.count += others.count;
        self.not_finite += others.not_finite;
        if let Some(extremes) = others.extremes {
            self.widen(extremes);
        }
        self.sum.merge(&others.sum);
        self.squares.merge(&others.squares);
    }

    /// The number of finite numbers.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The number of the others.
    #[must_use]
    pub fn not_finite(&self) -> u64 {
        self.not_finite
    }

    /// The mean, correctly rounded; `None` if there are no numbers.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        let (is_negative, size) = (self.count > 0).then(|| self.sum.whole())?;
        let mean = size.shifted(3).over(self.count).rounded(-1074 - 4 * 32);
        Some(if is_negative { -mean } else { mean })
    }

    /// The sample variance, correctly rounded: the sum of squared deviations from the mean, divided
    /// by the count minus one. `None` for fewer than two numbers.
    #[must_use]
    pub fn variance(&self) -> Option<f64> {
        let others = self.count.checked_sub(1).filter(|others| *others > 0)?;
        let variance = self.spread()?.shifted(4).over(self.count).over(others);
        Some(variance.rounded(-2148 - 6 * 32))
    }

    /// The count times the sum of squares, minus the square of the sum; `None` if negative, which
    /// is impossible for actual numbers.
    fn spread(&self) -> Option<Whole> {
        let ((_, sum), (_, squares)) = (self.sum.whole(), self.squares.whole());
        squares
            .times(&Whole::from(self.count))
            .minus(&sum.times(&sum))
    }

    /// Whether there can be numbers with these moments, as far as a cheap check can tell.
    #[cfg(feature = "serde")]
    pub(super) fn is_possible(&self) -> bool {
        let is_nothing = self.sum == Digits::ZERO && self.squares == Digits::ZERO;
        let are_extremes = |[least, greatest]: [f64; 2]| {
            least.is_finite() && greatest.is_finite() && least.total_cmp(&greatest).is_le()
        };
        match self.extremes {
            None => self.count == 0 && is_nothing,
            Some(extremes) => {
                let is_positive = !self.squares.whole().0;
                self.count > 0 && are_extremes(extremes) && is_positive && self.spread().is_some()
            }
        }
    }

    /// The least number; none of no numbers.
    #[must_use]
    pub fn least(&self) -> Option<f64> {
        self.extremes.map(|[least, _]| least)
    }

    /// The greatest number; none of no numbers.
    #[must_use]
    pub fn greatest(&self) -> Option<f64> {
        self.extremes.map(|[_, greatest]| greatest)
    }
}

impl Default for Moments {
    fn default() -> Self {
        Self::new()
    }
}

impl Extend<f64> for Moments {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, numbers: I) {
        numbers.into_iter().for_each(|number| self.add(number));
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(numbers: I) -> Self {
        let mut moments = Self::new();
        moments.extend(numbers);
        moments
    }
}
