//! Numbers and their residues.

use super::exact::Number;
use super::residue::{DIGITS, PRIME, Residue, minus};

impl Residue {
    /// The residue of a rational number. A multiple of the prime has none, because it is not zero.
    pub(in crate::symbolic) fn rational(number: &Number) -> Option<Self> {
        let [above, below] = number.modulo(PRIME).map(Self::real);
        let is_lost = above.is_zero() && !number.is_zero();
        Some(above * below.reciprocal()?).filter(|_| !is_lost)
    }

    /// The rational number with few digits that has this residue, if there is one.
    pub fn to_number(self) -> Option<Number> {
        let Residue { real, imaginary: 0 } = self else {
            return None;
        };
        let rest = i128::try_from(real.min(minus(real))).ok()?;
        let (mut last, mut number) = ((i128::try_from(PRIME).ok()?, 0), (rest, 1));
        // the fraction is one of the convergents of the continued fraction
        while number.0 >= DIGITS {
            let quotient = last.0 / number.0;
            (last, number) = (
                number,
                (last.0 - quotient * number.0, last.1 - quotient * number.1),
            );
        }
        let (above, below) = number;
        let is_negative = (below < 0) == (real <= minus(real));
        let above = i64::try_from(if is_negative { -above } else { above }).ok()?;
        let below = u64::try_from(below.unsigned_abs()).ok()?;
        (below < DIGITS.unsigned_abs().try_into().ok()?).then(|| Number::ratio(above, below))
    }
}
