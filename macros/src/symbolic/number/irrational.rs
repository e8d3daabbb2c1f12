//! Numbers that are not rational: a value, a bound of its error, and a residue that proves
//! identities.
//!
//! The residue is computed along with the value, modulo a prime. Pi and the values of functions
//! have random residues, up to `sin^2 + cos^2 = 1`. The root of a rational number is the product of
//! the roots of its prime factors. Sines and cosines of fractions of a turn are parts of powers of
//! one root of unity, which agrees with the roots of the primes that its order contains; no identity
//! distinguishes the signs of the other roots. A number is zero if its residue is zero and its value
//! may be: its residue is zero by an identity in all of these, except with probability 2^-100. A
//! value that has canceled down to its error, without being proved zero, is computed again with more
//! bits.

use core::cell::RefCell;
use std::rc::Rc;

use dashu_int::UBig;
use dashu_ratio::RBig;

use super::ball::{Ball, NONE};
use super::exact::{Irrational, Kind, Number, Term};
use super::float::{Float, PRECISION};
use super::function::Function;
use super::residue::Residue;

/// An exact number with more bits in numerator and denominator is rounded to [`PRECISION`].
const EXACT: usize = 1 << 13;
/// The same for a number that is rounded already, and the bits of it that are kept.
const ROUNDED: usize = 1 << 11;
const KEPT: usize = 1 << 9;
/// A value with fewer correct bits is computed again.
const ENOUGH: isize = 128;
/// The bits that it is computed with, one after another until they suffice.
const MORE: [usize; 4] = [512, 1024, 2048, 4096];
/// The most operations that are repeated.
const COST: usize = 200;

/// The exponent of the error of a quotient whose divisor may be zero: nothing is known about it.
const UNKNOWN: isize = 1 << 15;

thread_local! {
    static PI: Number = {
        let residue = Residue::stand_in(&"pi");
        Number::settled(Term::Pi.ball(PRECISION), residue, Term::Pi).unwrap_or_else(Number::zero)
    };
}

impl Term {
    fn cost(&self) -> usize {
        match self {
            Self::Pi | Self::Kept => 0,
            Self::Sum(a, b) | Self::Product(a, b) | Self::Quotient(a, b) => 1 + a.cost() + b.cost(),
            Self::Value(_, a) => 1 + a.cost(),
        }
    }

    /// Whether its value can become more accurate with more bits of its operands.
    fn may_gain(&self) -> bool {
        match self {
            Self::Pi => true,
            Self::Sum(a, b) => a.may_gain() || b.may_gain(),
            Self::Product(a, b) | Self::Quotient(a, b) => {
                let is_told = !a.is_undecided() && !b.is_undecided();
                is_told && (a.may_gain() || b.may_gain())
            }
            Self::Value(_, a) => !a.is_rounded() || a.may_gain(),
            Self::Kept => false,
        }
    }

    /// Its value, computed with this many bits of its operands.
    fn ball(&self, bits: usize) -> Option<Ball> {
        let exact = match self {
            Self::Pi => return Ball::of_float(Float::pi(bits), NONE, bits),
            Self::Sum(a, b) => Ball::sum(&a.ball(bits), &b.ball(bits)),
            Self::Product(a, b) => Ball::product(&a.ball(bits), &b.ball(bits)),
            Self::Quotient(a, b) => Ball::quotient(&a.ball(bits), &b.ball(bits))?,
            Self::Value(function, a) => return a.ball(bits).apply(*function, bits),
            Self::Kept => return None,
        };
        Some(Ball::rounded(&exact.value, exact.error, bits))
    }
}

impl Number {
    pub fn pi() -> Self {
        PI.with(Self::clone)
    }

    /// A value that is correct to this many bits, and of which nothing else is known.
    pub(in crate::symbolic) fn measured(value: Float, bits: usize) -> Self {
        let ball = Ball::of_float(value, NONE, bits);
        let residue = ball
            .as_ref()
            .map_or(Residue::ZERO, |ball| Residue::stand_in(&ball.value));
        Self::settled(ball, residue, Term::Kept).unwrap_or_else(Self::zero)
    }

    /// The value of one of the functions that others are made of.
    pub(in crate::symbolic) fn value_of(
        function: Function,
        x: &Self,
        residue: Option<Residue>,
    ) -> Option<Self> {
        let residue = residue.unwrap_or_else(|| Residue::stand_in(&(function, x.residue())));
        let near = Ball::rounded(&x.value, x.error(), PRECISION).apply(function, PRECISION);
        Self::settled(near, residue, Term::Value(function, x.clone()))
    }

    /// The argument, if this number is a value of this function.
    pub(in crate::symbolic) fn argument(&self, of: Function) -> Option<&Self> {
        match &self.known()?.term {
            Term::Value(function, argument) if *function == of => Some(argument),
            _ => None,
        }
    }

    pub(in crate::symbolic) fn sum(a: Self, b: Self) -> Self {
        let near = Ball::sum(&a.stored(), &b.stored());
        let residue = a.residue() + b.residue();
        Self::settled_or(near, residue, Term::Sum(a, b))
    }

    pub(in crate::symbolic) fn product(a: Self, b: Self) -> Self {
        if a.is_zero() || b.is_zero() {
            return Self::zero();
        }
        if let (Some(x), Some(y)) = (a.argument(Function::Sqrt), b.argument(Function::Sqrt))
            && x == y
        {
            return x.clone();
        }
        let near = Ball::product(&a.stored(), &b.stored());
        let residue = a.residue() * b.residue();
        Self::settled_or(near, residue, Term::Product(a, b))
    }

    pub(in crate::symbolic) fn quotient(a: Self, b: Self) -> Self {
        if a.is_zero() {
            return a;
        }
        let near = Ball::quotient(&a.stored(), &b.stored());
        let near = near.unwrap_or_else(|| Ball {
            value: &a.value / &b.value,
            error: UNKNOWN,
        });
        let residue = match b.residue().reciprocal() {
            Some(reciprocal) => a.residue() * reciprocal,
            None => Residue::stand_in(&near.value),
        };
        Self::settled_or(near, residue, Term::Quotient(a, b))
    }

    fn settled_or(near: Ball, residue: Residue, term: Term) -> Self {
        let value = near.value.clone();
        Self::settled(Some(near), residue, term).unwrap_or_else(|| Self::from(value))
    }

    /// The number near a value: zero or another rational number, if that is proved; otherwise
    /// irrational, with enough correct digits where they can be computed. `None` if there is no
    /// value.
    fn settled(mut near: Option<Ball>, mut residue: Residue, term: Term) -> Option<Self> {
        if let Some(ball) = &near
            && residue == Residue::ZERO
        {
            if ball.may_be_zero() {
                return Some(Self::zero());
            }
            residue = Residue::stand_in(&ball.value);
        }
        let may_gain = term.may_gain();
        for bits in MORE {
            if !may_gain || near.as_ref().is_some_and(|ball| ball.bits() >= ENOUGH) {
                break;
            }
            near = term.ball(bits).or(near);
        }
        let mut ball = near?;
        if ball.bits() >= ENOUGH
            && let Some(rational) = residue.to_number()
            && (Ball {
                value: &ball.value - &rational.value,
                ..ball
            })
            .may_be_zero()
        {
            return Some(rational);
        }
        if ball.may_be_zero() {
            // nothing is known but this bound: the number may have either sign
            ball.value = power_of_two(ball.error);
            ball.error += 4;
        }
        Some(Self::known_by(ball, residue, term).condensed())
    }

    fn known_by(ball: Ball, residue: Residue, term: Term) -> Self {
        let Ball { value, error } = ball;
        let cost = term.cost();
        let term = if cost > COST { Term::Kept } else { term };
        let known = Irrational {
            residue,
            error,
            cost: if cost > COST { 0 } else { cost },
            term,
            again: RefCell::default(),
        };
        Self {
            value,
            kind: Kind::Irrational(Rc::new(known)),
        }
    }

    /// Drops digits if there are far too many.
    pub(in crate::symbolic) fn condensed(self) -> Self {
        let (most, kept) = if self.is_rounded() {
            (ROUNDED, KEPT)
        } else {
            (EXACT, PRECISION)
        };
        if self.bits() < most || !self.is_carried() {
            return self;
        }
        self.near(kept)
    }

    /// The same with fewer digits.
    fn near(self, bits: usize) -> Self {
        let ball = Ball::rounded(&self.value, self.error(), bits);
        match &self.kind {
            Kind::Rational => Self::known_by(ball, self.residue(), Term::Kept),
            Kind::Irrational(known) => Self::known_by(ball, known.residue, known.term.clone()),
        }
    }

    /// Whether it can neither be distinguished from zero nor proved to be zero.
    pub fn is_undecided(&self) -> bool {
        self.known().is_some() && self.stored().may_be_zero()
    }

    /// Whether irrational numbers are proved to be equal.
    pub(in crate::symbolic) fn is_same(&self, other: &Self) -> bool {
        let difference = || Ball {
            value: &self.value - &other.value,
            error: self.error().max(other.error()) + 1,
        };
        self.residue() == other.residue() && difference().may_be_zero()
    }

    /// The rational number that an irrational expression is proved to be: the one with the fewest
    /// digits near its value, if both have the same residue.
    pub(super) fn to_rational(&self) -> Option<Self> {
        let ball = self.ball(MORE[0]);
        if ball.bits() < ENOUGH {
            return None;
        }
        let error = power_of_two(ball.error);
        let simplest = RBig::simplest_in(&ball.value - &error, &ball.value + &error);
        let simplest = Self::from(simplest);
        (Residue::rational(&simplest) == Some(self.residue())).then_some(simplest)
    }

    /// How it is computed, if it is not rational.
    pub(super) fn term(&self) -> Option<&Term> {
        Some(&self.known()?.term)
    }

    fn known(&self) -> Option<&Irrational> {
        match &self.kind {
            Kind::Irrational(known) => Some(known),
            Kind::Rational => None,
        }
    }

    /// The residue modulo the prime of the test for zeros; equal numbers have equal residues.
    pub fn residue(&self) -> Residue {
        match self.known() {
            Some(known) => known.residue,
            None => Residue::rational(self).unwrap_or_else(|| Residue::stand_in(&self.value)),
        }
    }

    fn error(&self) -> isize {
        self.known().map_or(NONE, |known| known.error)
    }

    fn cost(&self) -> usize {
        self.known().map_or(0, |known| known.cost)
    }

    fn stored(&self) -> Ball {
        Ball {
            value: self.value.clone(),
            error: self.error(),
        }
    }

    /// Whether more bits of it can be computed: not if even all of them did not distinguish it from
    /// zero.
    fn may_gain(&self) -> bool {
        (self.known())
            .is_some_and(|known| !matches!(known.term, Term::Kept) && !self.stored().may_be_zero())
    }

    /// Its value to this many bits, or the most accurate one that can be computed.
    fn ball(&self, bits: usize) -> Ball {
        let stored = Ball::rounded(&self.value, self.error(), bits);
        match self.known() {
            Some(known) if self.may_gain() && self.stored().bits() < bits.cast_signed() => {
                let again = known.again(bits);
                again
                    .filter(|again| again.error < stored.error)
                    .unwrap_or(stored)
            }
            _ => stored,
        }
    }
}

impl Irrational {
    /// Its value, computed with this many bits; remembered.
    fn again(&self, bits: usize) -> Option<Ball> {
        let known = self.again.borrow();
        if let Some((_, ball)) = known.iter().find(|(known, _)| *known == bits) {
            return ball.clone();
        }
        drop(known);
        let ball = self.term.ball(bits);
        self.again.borrow_mut().push((bits, ball.clone()));
        ball
    }
}

fn power_of_two(exponent: isize) -> RBig {
    let power = RBig::from(UBig::ONE << exponent.unsigned_abs().min(1 << 16));
    if exponent < 0 {
        RBig::ONE / power
    } else {
        power
    }
}
