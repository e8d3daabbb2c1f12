//! Numbers and their residues.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::exact::Number;
use super::function::Function;
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

/// The residue of the root of a positive rational number: the product of those of its prime factors.
/// If more than 64 bits remain without small factors, all that is known of this rest is that equal
/// numbers have equal residues.
pub fn root_residue(of: &Number) -> Option<Residue> {
    let (above, below) = (of.value.numerator(), of.value.denominator());
    let mut rest = u128::try_from(above * IBig::from(below.clone())).ok()?;
    let mut residue = Residue::rational(&Number::from(RBig::from(below.clone())))?.reciprocal()?;
    let mut times = |prime: u128, power: u32| {
        let prime = Residue::real(prime);
        for _ in 0..power / 2 {
            residue = residue * prime;
        }
        if power % 2 == 1 {
            residue = residue * prime.root()?;
        }
        Some(())
    };
    for divisor in core::iter::once(2).chain((3..1 << 16).step_by(2)) {
        let mut power = 0;
        while rest % divisor == 0 {
            (rest, power) = (rest / divisor, power + 1);
        }
        times(divisor, power)?;
        if divisor * divisor > rest {
            break;
        }
    }
    let mut primes = match u64::try_from(rest) {
        Ok(1) => Vec::new(),
        Ok(prime) if prime < 1 << 32 => vec![prime],
        Ok(rest) => large_factors(rest)?,
        Err(_) => return Some(residue * Residue::stand_in(&(Function::Sqrt, rest))),
    };
    primes.sort_unstable();
    for equal in primes.chunk_by(|one, other| one == other) {
        times(equal[0].into(), u32::try_from(equal.len()).ok()?)?;
    }
    Some(residue)
}

/// The prime factors of a number that has none below 2^16.
fn large_factors(of: u64) -> Option<Vec<u64>> {
    if is_prime(of) {
        return Some(vec![of]);
    }
    let divisor = (1..64).find_map(|step| divisor(of, step))?;
    Some([large_factors(divisor)?, large_factors(of / divisor)?].concat())
}

/// Miller and Rabin's test, which is a proof below 2^64 with these bases.
fn is_prime(of: u64) -> bool {
    let (twos, odd) = (
        (of - 1).trailing_zeros(),
        (of - 1) >> (of - 1).trailing_zeros(),
    );
    let passes = |base: u64| {
        let first = (0..64).rev().fold(1, |power, bit| {
            let square = product(power, power, of);
            if odd >> bit & 1 == 1 {
                product(square, base, of)
            } else {
                square
            }
        });
        let squares = core::iter::successors(Some(first), |last| Some(product(*last, *last, of)));
        first == 1 || squares.take(twos as usize).any(|square| square == of - 1)
    };
    [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37]
        .into_iter()
        .all(passes)
}

/// A divisor of a composite number, by Pollard's method: two points on the path of `x^2 + step` that
/// agree modulo a divisor. `None` if they agree modulo the number itself.
fn divisor(of: u64, step: u64) -> Option<u64> {
    let next = |x: u64| (product(x, x, of) + step) % of;
    let (mut slow, mut fast) = (2, 2);
    loop {
        (slow, fast) = (next(slow), next(next(fast)));
        let common = common_divisor(slow.abs_diff(fast), of);
        if common != 1 {
            return (common != of).then_some(common);
        }
    }
}

fn common_divisor(a: u64, b: u64) -> u64 {
    if a == 0 { b } else { common_divisor(b % a, a) }
}

fn product(a: u64, b: u64, modulo: u64) -> u64 {
    let rest = u128::from(a) * u128::from(b) % u128::from(modulo);
    u64::try_from(rest).unwrap_or_default()
}
