//! Numbers modulo a prime: a field in which nothing is rounded and nothing grows.

use core::ops::{Add, Mul, Neg};
use std::hash::{DefaultHasher, Hash, Hasher};

/// The largest prime below 2^127 for which `PRIME + 1` is a multiple of [`ORDER`]. Modulo it, -1 has
/// no square root; of a nonzero `a` and `-a`, exactly one has.
pub const PRIME: u128 = (1 << 127) - BELOW;
const BELOW: u128 = 45_263_724_105_729;

/// The bound of numerator and denominator below which a residue determines a fraction. By chance,
/// one residue in 2^62 has such a fraction.
pub const DIGITS: i128 = 1 << 32;

/// `real + imaginary i`, both modulo the prime. Among these numbers, every real one has a root.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Residue {
    pub real: u128,
    pub imaginary: u128,
}

impl Residue {
    pub const ZERO: Self = Self::real(0);
    pub const ONE: Self = Self::real(1);

    pub(in crate::symbolic) const fn real(real: u128) -> Self {
        Self { real, imaginary: 0 }
    }

    /// A pseudorandom residue: the same for equal arguments, in every run.
    pub fn stand_in(of: &impl Hash) -> Self {
        let half = |salt: u8| {
            let mut hasher = DefaultHasher::new();
            (salt, of).hash(&mut hasher);
            u128::from(hasher.finish())
        };
        Self::real(reduced(half(0) << 64 | half(1)))
    }

    pub fn is_zero(self) -> bool {
        self == Self::ZERO
    }

    /// The same residue for `a` and `-a`, and whether it is the negative of this one.
    pub(in crate::symbolic) fn unsigned(self) -> (Self, bool) {
        let opposite = -self;
        let key = |a: &Self| (a.real, a.imaginary);
        if key(&self) <= key(&opposite) {
            (self, false)
        } else {
            (opposite, true)
        }
    }

    /// The reciprocal of a nonzero real number.
    fn inverse(a: u128) -> u128 {
        power(a, PRIME - 2, 1, times)
    }

    fn conjugate(self) -> Self {
        Self {
            imaginary: minus(self.imaginary),
            ..self
        }
    }

    pub fn reciprocal(self) -> Option<Self> {
        let Self { real, imaginary } = self;
        if self == Self::ONE {
            return Some(self);
        }
        if imaginary == 0 {
            return (real != 0).then(|| Self::real(Self::inverse(real)));
        }
        let square = plus(times(real, real), times(imaginary, imaginary));
        (square != 0).then(|| self.conjugate() * Self::real(Self::inverse(square)))
    }

    /// The real root of a real number, `a^((PRIME + 1) / 4)`, if it has one.
    fn real_root(a: u128) -> Option<u128> {
        let root = power(a, PRIME.div_ceil(4), 1, times);
        (times(root, root) == a).then_some(root)
    }

    pub(in crate::symbolic) fn root(self) -> Option<Self> {
        let Self { real, imaginary } = self;
        if imaginary == 0 {
            let root = Self::real_root(real).map(Self::real);
            let rotated = |root| Self {
                real: 0,
                imaginary: root,
            };
            return root.or_else(|| Self::real_root(minus(real)).map(rotated));
        }
        // x + y i with 2 x^2 = a + |a + b i| and 2 x y = b
        let size = Self::real_root(plus(times(real, real), times(imaginary, imaginary)))?;
        let half = PRIME.div_ceil(2);
        let squares = [size, minus(size)].map(|size| times(half, plus(real, size)));
        let x = squares.into_iter().find_map(Self::real_root)?;
        let y = times(imaginary, Self::inverse(plus(x, x)));
        Some(Self {
            real: x,
            imaginary: y,
        })
    }
}

/// A power of any number, by the digits of the exponent in base 16.
fn power<T: Copy>(base: T, exponent: u128, one: T, times: impl Fn(T, T) -> T) -> T {
    let mut powers = [one; 16];
    for count in 1..16 {
        powers[count] = times(powers[count - 1], base);
    }
    let digits = (0..u128::BITS - exponent.leading_zeros()).step_by(4).rev();
    digits.fold(one, |power, digit| {
        let power = (0..4).fold(power, |power, _| times(power, power));
        times(power, powers[(exponent >> digit & 15) as usize])
    })
}

/// The residue of any number of 128 bits.
fn reduced(a: u128) -> u128 {
    // 2^127 = BELOW
    let folded = (a & HALF) + (a >> 127) * BELOW;
    if folded >= PRIME {
        folded - PRIME
    } else {
        folded
    }
}

const HALF: u128 = (1 << 127) - 1;

fn plus(a: u128, b: u128) -> u128 {
    let sum = a + b;
    if sum < PRIME { sum } else { sum - PRIME }
}

pub fn minus(a: u128) -> u128 {
    if a == 0 { 0 } else { PRIME - a }
}

fn times(a: u128, b: u128) -> u128 {
    let ([a_high, a_low], [b_high, b_low]) = ([a >> 64, a & LOW], [b >> 64, b & LOW]);
    let [low, middle] = [a_low * b_low, a_high * b_low + a_low * b_high];
    let high = a_high * b_high + (middle >> 64);
    let lows = plus(reduced(low), reduced(middle << 64));
    // the upper half of the high part first
    let upper = (high >> 64) * OF_128;
    let rest = ((high & LOW) + (upper >> 64)) * OF_128;
    plus(lows, plus(reduced(upper << 64), reduced(rest)))
}

const LOW: u128 = (1 << 64) - 1;
/// 2^128 modulo the prime.
const OF_128: u128 = 2 * BELOW;

/// The order of a root of unity z. The sines and cosines of fractions of a turn are parts of its
/// powers, so those of sums and multiples of such angles have the residues that they should have:
///
/// ```text
/// e^(i turn k / ORDER) = z^k,   z^ORDER = 1
/// ```
///
/// Degrees with up to five decimals are such fractions. The order divides `PRIME + 1`; therefore
/// the reciprocal of a power is its conjugate, and sines and cosines are real.
pub(super) const ORDER: u64 = (1 << 12) * 27 * 78_125 * 7 * 11 * 13;
pub(super) const FACTORS: [u64; 6] = [2, 3, 5, 7, 11, 13];

/// The root of unity z that agrees with the roots of [`FACTORS`], if it exists. These roots are sums
/// of its powers (Gauss sums); all other roots of integers are independent of it:
///
/// ```text
/// z^(ORDER / 4) = i,   z^(ORDER / 8) + z^(-ORDER / 8) = sqrt(2),
/// sum over k of (k / p) z^(k ORDER / p) = sqrt(p), or i sqrt(p) if p = 3 modulo 4
/// ```
pub(super) fn root_of_unity(roots: [Residue; FACTORS.len()]) -> Option<Residue> {
    let is_primitive = |root: &Residue| {
        let is_one = |factor: &u64| on_circle(*root, ORDER / factor) == Residue::ONE;
        !FACTORS.iter().any(is_one)
    };
    let candidates = (0_u8..64).map(|seed| {
        let any = Residue::stand_in(&seed) + I * Residue::stand_in(&(seed, 1));
        let of_one = any.conjugate() * any.reciprocal()?;
        let exponent = (PRIME + 1) / u128::from(ORDER);
        Some(power(of_one, exponent, Residue::ONE, Residue::mul))
    });
    let root = candidates.flatten().find(is_primitive)?;
    let agrees = |root: &Residue| {
        let [of_two, others @ ..] = roots;
        let eighth = on_circle(*root, ORDER / 8);
        let mut odd = FACTORS[1..].iter().zip(others);
        eighth * eighth == I
            && eighth + eighth.conjugate() == of_two
            && odd.all(|(prime, of_prime)| {
                let turned = if prime % 4 == 1 { Residue::ONE } else { I };
                gauss_sum(on_circle(*root, ORDER / prime), *prime) == turned * of_prime
            })
    };
    let is_coprime = |count: &u64| !FACTORS.iter().any(|of| count.is_multiple_of(*of));
    let powers = (1..1 << 16).filter(is_coprime);
    powers.map(|count| on_circle(root, count)).find(agrees)
}

/// The sum of the powers of a root of unity of prime order, minus those whose exponent is no square
/// modulo the prime.
fn gauss_sum(root: Residue, prime: u64) -> Residue {
    let is_square = |count: u64| (1..prime).any(|one| one * one % prime == count);
    let (mut sum, mut power) = (Residue::ZERO, Residue::ONE);
    for count in 1..prime {
        power = power * root;
        sum = sum + if is_square(count) { power } else { -power };
    }
    sum
}

const I: Residue = Residue {
    real: 0,
    imaginary: 1,
};

/// The residue of `e^(i angle)` for an angle of this many parts; a turn has [`ORDER`] parts.
pub(super) fn on_circle(root_of_unity: Residue, parts: u64) -> Residue {
    power(root_of_unity, parts.into(), Residue::ONE, Residue::mul)
}

impl Add for Residue {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            real: plus(self.real, other.real),
            imaginary: plus(self.imaginary, other.imaginary),
        }
    }
}

impl Neg for Residue {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            real: minus(self.real),
            imaginary: minus(self.imaginary),
        }
    }
}

impl Mul for Residue {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let real = times(self.real, other.real);
        if self.imaginary == 0 && other.imaginary == 0 {
            return Self::real(real);
        }
        let square = times(self.imaginary, other.imaginary);
        Self {
            real: plus(real, minus(square)),
            imaginary: plus(
                times(self.real, other.imaginary),
                times(self.imaginary, other.real),
            ),
        }
    }
}
