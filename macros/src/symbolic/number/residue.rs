//! Numbers modulo a prime: a field in which nothing is rounded and nothing grows.

use core::ops::{Add, Mul, Neg};
use std::hash::{DefaultHasher, Hash, Hasher};

/// A Mersenne prime. Modulo it, -1 has no square root; of a nonzero `a` and `-a`, exactly one has.
pub const PRIME: u128 = (1 << 127) - 1;

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

    /// A random residue, different for different arguments.
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

    /// The reciprocal of a nonzero real number, `a^(PRIME - 2)`.
    fn inverse(a: u128) -> u128 {
        // a^(2^count - 1), by doubling the count or adding one to it, up to 125
        let (mut power, mut count) = (a, 1);
        for is_odd in [true, true, true, true, false, true] {
            (power, count) = (times(squared(power, count), power), 2 * count);
            if is_odd {
                (power, count) = (times(squared(power, 1), a), count + 1);
            }
        }
        times(squared(power, 2), a)
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
        let over = Self::real(Self::inverse(square));
        (square != 0).then(|| {
            Self {
                real,
                imaginary: minus(imaginary),
            } * over
        })
    }

    /// The real root of a real number, `a^((PRIME + 1) / 4)`, if it has one.
    fn real_root(a: u128) -> Option<u128> {
        let root = squared(a, 125);
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

/// `a`, squared this many times.
fn squared(a: u128, count: u32) -> u128 {
    (0..count).fold(a, |power, _| times(power, power))
}

/// The residue of any number of 128 bits.
fn reduced(a: u128) -> u128 {
    let folded = (a & PRIME) + (a >> 127);
    if folded >= PRIME {
        folded - PRIME
    } else {
        folded
    }
}

fn plus(a: u128, b: u128) -> u128 {
    let sum = a + b;
    if sum < PRIME { sum } else { sum - PRIME }
}

pub fn minus(a: u128) -> u128 {
    if a == 0 { 0 } else { PRIME - a }
}

fn times(a: u128, b: u128) -> u128 {
    const LOW: u128 = (1 << 64) - 1;
    let ([a_high, a_low], [b_high, b_low]) = ([a >> 64, a & LOW], [b >> 64, b & LOW]);
    let middle = a_high * b_low + a_low * b_high;
    // 2^128 = 2
    let high = plus(2 * a_high * b_high, 2 * (middle >> 64));
    let low = plus(reduced((middle & LOW) << 64), reduced(a_low * b_low));
    plus(reduced(high), low)
}

/// The order of a root of unity z, by whose powers sines and cosines of fractions of a turn have
/// residues:
///
/// ```text
/// e^(i turn) = z^k,  z^ORDER = 1:    cos = (z^k + z^-k) / 2,  sin = (z^k - z^-k) / 2 i
/// ```
///
/// So sums and multiples of such angles have the residues that they should have. Multiples of 5
/// degrees are fractions of a turn that z has, and so are their halves, but not 1 degree. The order
/// divides `PRIME^2 - 1 = 2^128 (2^126 - 1)`, which five does not.
pub(super) const ORDER: u32 = 27 << TWOS;
const TWOS: u32 = 20;

fn power(mut base: Residue, mut exponent: u128) -> Residue {
    let mut power = Residue::ONE;
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = power * base;
        }
        base = base * base;
        exponent >>= 1;
    }
    power
}

/// The root of unity with which a 24th of a turn has these residues of its cosine and sine.
pub(super) fn root_of_unity([cosine, sine]: [Residue; 2]) -> Option<Residue> {
    let i = Residue {
        real: 0,
        imaginary: 1,
    };
    let of_24 = cosine + i * sine;
    let any = (0_u8..64).map(|seed| Residue::stand_in(&seed) + i * Residue::stand_in(&(seed, 1)));
    let mut roots = any.map(|any| {
        let twos = (0..128 - TWOS).fold(any, |power, _| power * power);
        power(twos, (PRIME / 2) / 27)
    });
    let root = roots.find(|root| {
        let is_one = |part: u32| power(*root, u128::from(ORDER / part)) == Residue::ONE;
        !is_one(2) && !is_one(3)
    })?;
    let unit = power(root, u128::from(ORDER / 24));
    let turns = [1, 5, 7, 11, 13, 17, 19, 23].into_iter();
    let mut same = turns.filter(|turns| power(unit, *turns) == of_24);
    Some(power(root, same.next()?))
}

/// The residues of the cosine and the sine of this many parts of a turn, of which it has [`ORDER`].
pub(super) fn on_circle(z: Residue, count: i64) -> Option<[Residue; 2]> {
    let count = count.rem_euclid(i64::from(ORDER));
    let turned = power(z, u128::try_from(count).ok()?);
    let back = turned.reciprocal()?;
    let half = Residue::real(PRIME.div_ceil(2));
    let minus_i = Residue {
        real: 0,
        imaginary: PRIME - 1,
    };
    Some([(turned + back) * half, (turned + -back) * half * minus_i])
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
