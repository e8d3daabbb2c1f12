//! Arithmetic modulo a prime: an expression that is zero at a random place is zero identically.
//!
//! Symbols have random residues. What is not known of a value is a random residue too, the same for
//! equal arguments: that of a sine by the tangent of half its angle, that of a hyperbolic function by
//! the exponential of its argument, that of any other function by itself; a number that is not rational
//! carries its residue along ([`super::irrational`]). A root has both signs, and a condition both outcomes: each is a branch of its own. A root
//! of a root may have no residue, and is random too.
//!
//! What is zero at the place on every branch is so in all states, for all such functions, but for one
//! chance in `PRIME / degree` (J. Schwartz, Fast probabilistic algorithms for verification of
//! polynomial identities, J. ACM 27, 1980, 701; R. Zippel, Probabilistic algorithms for sparse
//! polynomials, EUROSAM 1979). What is not zero there may be zero all the same: `sin 2x - 2 sin x cos x`.

use core::ops::{Add, Mul, Neg};
use std::hash::{DefaultHasher, Hash, Hasher};

use super::algebra::Algebra;
use super::branches::Side;
use super::function::Function;
use super::graph::Comparison;
use super::number::Number;

/// Of Mersenne; -1 has no root, and of `a` and `-a` one has.
pub(super) const PRIME: u128 = (1 << 127) - 1;

/// Bound of a numerator and of a denominator that are told by their residue: one of 2^62 has such, by
/// chance.
const DIGITS: i128 = 1 << 32;

/// `real + imaginary i`, both modulo [`PRIME`]: numbers among which all that are real have roots.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Residue {
    real: u128,
    imaginary: u128,
}

/// Residues on one branch; `None` is a quotient by zero.
pub struct Residues<'a> {
    side: &'a mut dyn FnMut(Side) -> Option<bool>,
}

impl<'a> Residues<'a> {
    /// Residues on the branch that `side` tells; without an answer a choice is a symbol too.
    pub(super) fn new(side: &'a mut dyn FnMut(Side) -> Option<bool>) -> Self {
        Self { side }
    }

    /// A sine, a cosine or a tangent, by the tangent of half the angle.
    fn on_circle(function: Function, angle: Residue) -> Option<Residue> {
        let tangent = Self::odd(Function::Tan, angle);
        let square = tangent * tangent;
        let (sine, cosine) = (tangent + tangent, Residue::ONE + -square);
        let (above, below) = match function {
            Function::Sin => (sine, Residue::ONE + square),
            Function::Cos => (cosine, Residue::ONE + square),
            _ => (sine, cosine),
        };
        Some(above * below.reciprocal()?)
    }

    /// A hyperbolic function, by the exponential of its argument.
    fn on_hyperbola(function: Function, a: Residue) -> Option<Residue> {
        let grown = Self::exponential(a)?;
        let decayed = grown.reciprocal()?;
        let (sinh, cosh) = (grown + -decayed, grown + decayed);
        let below = match function {
            Function::Tanh => cosh,
            _ => Residue::ONE + Residue::ONE,
        };
        let above = if function == Function::Cosh {
            cosh
        } else {
            sinh
        };
        Some(above * below.reciprocal()?)
    }

    /// `e^-a = 1 / e^a`
    fn exponential(a: Residue) -> Option<Residue> {
        let (size, is_turned) = a.unsigned();
        let grown = Residue::stand_in(&(Function::Exp, size));
        if is_turned {
            grown.reciprocal()
        } else {
            Some(grown)
        }
    }

    /// `f(-a) = -f(a)`
    fn odd(function: Function, a: Residue) -> Residue {
        if a == Residue::ZERO {
            return Residue::ZERO;
        }
        let (size, is_turned) = a.unsigned();
        let value = Residue::stand_in(&(function, size));
        if is_turned { -value } else { value }
    }

    /// Of either sign.
    fn root(&mut self, a: Residue) -> Residue {
        if a.is_zero() {
            return a;
        }
        let Some(is_turned) = (self.side)(Side::Root(a)) else {
            return Residue::stand_in(&(Function::Sqrt, a));
        };
        let root = a
            .root()
            .unwrap_or_else(|| Residue::stand_in(&(Function::Sqrt, a)));
        if is_turned { -root } else { root }
    }

    /// Whether a number is below zero: one, zero, or a symbol.
    fn is_below_zero(&mut self, a: Residue) -> Residue {
        if a.is_zero() {
            return Residue::ZERO;
        }
        match (self.side)(Side::Below(a)) {
            Some(holds) => Residue::real(u128::from(holds)),
            None => Residue::stand_in(&("below", a)),
        }
    }

    /// Whether it is zero.
    fn is_nothing(&mut self, a: Residue) -> Residue {
        if a.is_zero() {
            return Residue::ONE;
        }
        match (self.side)(Side::Nothing(a)) {
            Some(holds) => Residue::real(u128::from(holds)),
            None => Residue::stand_in(&("nothing", a)),
        }
    }

    /// `first` where `a < b`, else `second`.
    fn where_less(&mut self, [a, b]: [Residue; 2], first: Residue, second: Residue) -> Residue {
        let is_less = self.is_below_zero(a + -b);
        second + is_less * (first + -second)
    }
}

impl Residue {
    pub const ZERO: Self = Self::real(0);
    pub const ONE: Self = Self::real(1);

    pub(super) const fn real(real: u128) -> Self {
        Self { real, imaginary: 0 }
    }

    /// A random residue, different for what is different.
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

    /// Of `a` and `-a` always the same one, and whether it is the other.
    pub(super) fn unsigned(self) -> (Self, bool) {
        let opposite = -self;
        let key = |a: &Self| (a.real, a.imaginary);
        if key(&self) <= key(&opposite) {
            (self, false)
        } else {
            (opposite, true)
        }
    }

    /// That of a rational number. A multiple of the prime has none, as it is not zero.
    pub(super) fn rational(number: &Number) -> Option<Self> {
        let [above, below] = number.modulo(PRIME).map(Self::real);
        let is_lost = above.is_zero() && !number.is_zero();
        Some(above * below.reciprocal()?).filter(|_| !is_lost)
    }

    /// The rational number of few digits that it is.
    pub fn to_number(self) -> Option<Number> {
        let Residue { real, imaginary: 0 } = self else {
            return None;
        };
        let rest = i128::try_from(real.min(minus(real))).ok()?;
        let (mut last, mut number) = ((i128::try_from(PRIME).ok()?, 0), (rest, 1));
        // a fraction of its convergents is the number over its denominator
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

    /// `a^exponent` of a real number.
    fn power(a: u128, exponent: u128) -> u128 {
        let mut power = 1;
        for bit in (0..u128::BITS - exponent.leading_zeros()).rev() {
            power = times(power, power);
            if exponent >> bit & 1 == 1 {
                power = times(power, a);
            }
        }
        power
    }

    pub fn reciprocal(self) -> Option<Self> {
        let Self { real, imaginary } = self;
        if self == Self::ONE {
            return Some(self);
        }
        if imaginary == 0 {
            return (real != 0).then(|| Self::real(Self::power(real, PRIME - 2)));
        }
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
    fn real_root(a: u128) -> Option<u128> {
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

/// Of any number of 128 bits.
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

fn minus(a: u128) -> u128 {
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

impl Algebra for Residues<'_> {
    type Value = Option<Residue>;

    fn number(&mut self, number: &Number) -> Option<Residue> {
        Some(number.residue())
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
        Some((*a)? * (*b)?.reciprocal()?)
    }

    fn apply(&mut self, function: Function, arguments: &[Option<Residue>]) -> Option<Residue> {
        let arguments: Vec<Residue> = arguments.iter().copied().collect::<Option<_>>()?;
        match (function, arguments.as_slice()) {
            (Function::Sin | Function::Cos | Function::Tan, [a]) => Self::on_circle(function, *a),
            (Function::Sinh | Function::Cosh | Function::Tanh, [a]) => {
                Self::on_hyperbola(function, *a)
            }
            (Function::Exp, [a]) => Self::exponential(*a),
            (Function::Asin | Function::Atan | Function::Cbrt, [a]) => {
                Some(Self::odd(function, *a))
            }
            (Function::Sqrt, [a]) => Some(self.root(*a)),
            (Function::Hypot, [a, b]) => Some(self.root(*a * *a + *b * *b)),
            (Function::Abs, [a]) => Some(self.where_less([*a, Residue::ZERO], -*a, *a)),
            (Function::Signum, [a]) => {
                Some(self.where_less([*a, Residue::ZERO], -Residue::ONE, Residue::ONE))
            }
            (Function::Min, [a, b]) => Some(self.where_less([*a, *b], *a, *b)),
            (Function::Max, [a, b]) => Some(self.where_less([*b, *a], *a, *b)),
            _ => Some(Residue::stand_in(&(function, arguments))),
        }
    }

    fn is_zero(&self, a: &Option<Residue>) -> bool {
        *a == Some(Residue::ZERO)
    }

    fn compare(
        &mut self,
        comparison: Comparison,
        a: &Option<Residue>,
        b: &Option<Residue>,
    ) -> Option<Residue> {
        let (a, b) = ((*a)?, (*b)?);
        Some(match comparison {
            Comparison::Less => self.is_below_zero(a + -b),
            Comparison::LessOrEqual => Residue::ONE + -self.is_below_zero(b + -a),
            Comparison::Equal => self.is_nothing(a + -b),
            Comparison::NotEqual => Residue::ONE + -self.is_nothing(a + -b),
        })
    }

    fn select(
        &mut self,
        condition: &Option<Residue>,
        first: &Option<Residue>,
        second: &Option<Residue>,
    ) -> Option<Residue> {
        match (*condition)? {
            Residue::ONE => *first,
            Residue::ZERO => *second,
            share => Some((*second)? + share * ((*first)? + -(*second)?)),
        }
    }
}
