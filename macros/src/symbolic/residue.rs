//! Arithmetic modulo a prime: whether an expression is zero in all states, without long numbers.
//!
//! A state is a random residue for each symbol. What is not zero identically is zero in one of 2^50 of
//! them, or is a written multiple of the prime. A function has a random value for each argument, as has a
//! number that is not rational. Of what holds between such values little is known, that of a root its square
//! is its argument and that `sin^2 + cos^2 = 1`: what is not zero may be. And a root has either sign: what is
//! zero may be so for that sign alone, which doubles see.

use core::ops::{Add, Mul, Neg};
use std::hash::{DefaultHasher, Hash, Hasher};

use super::algebra::Algebra;
use super::function::Function;
use super::number::Number;

/// Of Mersenne; -1 has no root, and of `a` and `-a` one has.
const PRIME: u64 = (1 << 61) - 1;

/// Bound of a numerator and of a denominator that are told by their residue: one of 2^30 has such, by chance.
const DIGITS: i64 = 1 << 15;

/// `real + imaginary i`, both modulo [`PRIME`]: numbers among which all that are real have roots.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Residue {
    real: u64,
    imaginary: u64,
}

/// Residues; `None` is a quotient by zero.
#[derive(Default)]
pub struct Residues {
    /// There were functions, or numbers that are not rational.
    has_stand_ins: bool,
}

impl Residues {
    /// Whether what is not zero is not zero.
    pub fn is_final(&self) -> bool {
        !self.has_stand_ins
    }

    fn stand_in(&mut self, of: impl Hash) -> Residue {
        self.has_stand_ins = true;
        let mut hasher = DefaultHasher::new();
        of.hash(&mut hasher);
        Residue::real(hasher.finish() % PRIME)
    }

    /// A sine, or a cosine, by the tangent of half the angle.
    fn on_circle(&mut self, function: Function, angle: Residue) -> Option<Residue> {
        let tangent = self.stand_in((Function::Tan, angle));
        let square = tangent * tangent;
        let above = match function {
            Function::Sin => tangent + tangent,
            _ => Residue::ONE + -square,
        };
        Some(above * (Residue::ONE + square).reciprocal()?)
    }

    fn root(&mut self, a: Residue) -> Residue {
        self.has_stand_ins = true;
        a.root()
            .unwrap_or_else(|| self.stand_in((Function::Sqrt, a)))
    }
}

impl Residue {
    pub(super) const ZERO: Self = Self::real(0);
    pub(super) const ONE: Self = Self::real(1);

    pub(super) const fn real(real: u64) -> Self {
        Self { real, imaginary: 0 }
    }

    /// That of a rational number, unless the prime divides its denominator.
    pub(super) fn rational(number: &Number) -> Option<Self> {
        let [above, below] = number.modulo(PRIME).map(Self::real);
        Some(above * below.reciprocal()?)
    }

    /// The rational number of few digits that it is.
    pub fn to_number(self) -> Option<Number> {
        let Residue { real, imaginary: 0 } = self else {
            return None;
        };
        let rest = i64::try_from(real.min(minus(real))).ok()?;
        let (mut last, mut number) = ((i64::try_from(PRIME).ok()?, 0), (rest, 1));
        // a fraction of its convergents is the number over its denominator
        while number.0 >= DIGITS {
            let quotient = last.0 / number.0;
            (last, number) = (
                number,
                (last.0 - quotient * number.0, last.1 - quotient * number.1),
            );
        }
        let (above, below) = number;
        let sign = if below < 0 { -1 } else { 1 };
        let sign = if real <= minus(real) { sign } else { -sign };
        (below.abs() < DIGITS).then(|| Number::ratio(sign * above, below.unsigned_abs()))
    }

    /// `a^exponent` of a real number.
    fn power(a: u64, exponent: u64) -> u64 {
        let mut power = 1;
        for bit in (0..u64::BITS - exponent.leading_zeros()).rev() {
            power = times(power, power);
            if exponent >> bit & 1 == 1 {
                power = times(power, a);
            }
        }
        power
    }

    pub(super) fn reciprocal(self) -> Option<Self> {
        let Self { real, imaginary } = self;
        let square = plus(times(real, real), times(imaginary, imaginary));
        let over = Self::real(Self::power(square, PRIME - 2));
        (square != 0).then(|| {
            Self {
                real,
                imaginary: minus(imaginary),
            } * over
        })
    }

    /// Of a real number, if it has one that is real.
    fn real_root(a: u64) -> Option<u64> {
        let root = Self::power(a, PRIME.div_ceil(4));
        (times(root, root) == a).then_some(root)
    }

    pub(super) fn root(self) -> Option<Self> {
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
        let y = times(imaginary, Self::power(plus(x, x), PRIME - 2));
        Some(Self {
            real: x,
            imaginary: y,
        })
    }
}

fn plus(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum < PRIME { sum } else { sum - PRIME }
}

fn minus(a: u64) -> u64 {
    if a == 0 { 0 } else { PRIME - a }
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "the low bits, and the high ones"
)]
fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    plus(product as u64 & PRIME, (product >> 61) as u64)
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

impl Algebra for Residues {
    type Value = Option<Residue>;

    fn number(&mut self, number: &Number) -> Option<Residue> {
        if number.is_rounded() {
            let magnitude = self.stand_in(number.abs());
            return Some(if number.is_negative() {
                -magnitude
            } else {
                magnitude
            });
        }
        let [above, below] = number.modulo(PRIME).map(Residue::real);
        self.divide(&Some(above), &Some(below))
    }

    fn undefined(&mut self) -> Option<Residue> {
        None
    }

    fn negate(&mut self, a: &Option<Residue>) -> Option<Residue> {
        Some(-(*a)?)
    }

    fn add(&mut self, a: &Option<Residue>, b: &Option<Residue>) -> Option<Residue> {
        Some((*a)? + (*b)?)
    }

    fn multiply(&mut self, a: &Option<Residue>, b: &Option<Residue>) -> Option<Residue> {
        Some((*a)? * (*b)?)
    }

    fn divide(&mut self, a: &Option<Residue>, b: &Option<Residue>) -> Option<Residue> {
        let (a, b) = ((*a)?, (*b)?);
        Some(if b == Residue::ONE {
            a
        } else {
            a * b.reciprocal()?
        })
    }

    fn apply(&mut self, function: Function, arguments: &[Option<Residue>]) -> Option<Residue> {
        let arguments: Vec<Residue> = arguments.iter().copied().collect::<Option<_>>()?;
        match (function, arguments.as_slice()) {
            (Function::Sin | Function::Cos, [angle]) => self.on_circle(function, *angle),
            (Function::Sqrt, [a]) => Some(self.root(*a)),
            (Function::Hypot, [a, b]) => Some(self.root(*a * *a + *b * *b)),
            _ => Some(self.stand_in((function, arguments))),
        }
    }

    fn is_zero(&self, a: &Option<Residue>) -> bool {
        *a == Some(Residue::ZERO)
    }

    fn is_not_zero(&self, a: &Option<Residue>) -> bool {
        a.is_some_and(|a| a != Residue::ZERO)
    }
}
