//! The degrees of expressions, which bound the probability that a nonzero expression is zero at a
//! random place.

use crate::symbolic::algebra::{Algebra, Tape};
use crate::symbolic::graph::Comparison;
use crate::symbolic::number::{Foreign, Function, Number};

use super::powers::MOST;

/// Bounds of the degrees of numerator and denominator, in symbols and in everything treated as one.
#[derive(Clone, Copy)]
pub(in crate::symbolic) struct Degree {
    above: f64,
    below: f64,
}

struct Degrees;

/// The degree of a value without a known form: a symbol, or a rational function of a symbol with
/// squares.
const UNKNOWN: Degree = Degree {
    above: 2.0,
    below: 2.0,
};

/// The degree of a function of a sum, by powers of its values at the terms.
const OF_SUM: Degree = Degree {
    above: 2.0 * MOST,
    below: 2.0 * MOST,
};

/// Expressions that are made from these, such as rates of change and determinants, may have this
/// many times their degrees.
const MADE: f64 = 64.0;
/// A proof is wrong in at most one of this many cases: 2^60.
const CERTAINTY: f64 = 1_152_921_504_606_846_976.0;
/// 2^127, which the prime is just below.
const PRIME: f64 = CERTAINTY * CERTAINTY * 128.0;

impl Tape<'_> {
    /// Whether the degree is low enough for one random value to prove an identity: an expression that
    /// is zero at a random place is zero everywhere, and two that are equal there are equal everywhere.
    pub fn has_small_degree(&self) -> bool {
        let degrees = self.values(&mut Degrees, |_, _| UNKNOWN);
        let sum: f64 = degrees.iter().map(|of| of.above + of.below).sum();
        let count: f64 = degrees.iter().map(|_| 1.0).sum();
        MADE * count * sum * CERTAINTY < PRIME
    }
}

impl Algebra for Degrees {
    type Value = Degree;

    fn number(&mut self, _: &Number) -> Degree {
        Degree {
            above: 0.0,
            below: 0.0,
        }
    }

    fn undefined(&mut self) -> Degree {
        UNKNOWN
    }

    fn negate(&mut self, a: &Degree) -> Degree {
        *a
    }

    fn add(&mut self, a: &Degree, b: &Degree) -> Degree {
        Degree {
            above: (a.above + b.below).max(b.above + a.below),
            below: a.below + b.below,
        }
    }

    fn multiply(&mut self, a: &Degree, b: &Degree) -> Degree {
        Degree {
            above: a.above + b.above,
            below: a.below + b.below,
        }
    }

    fn divide(&mut self, a: &Degree, b: &Degree) -> Degree {
        Degree {
            above: a.above + b.below,
            below: a.below + b.above,
        }
    }

    fn apply(&mut self, function: Function, arguments: &[Degree]) -> Degree {
        match (function, arguments) {
            (Function::Sqrt | Function::Abs, [a]) => *a,
            (Function::Hypot, [a, b]) => {
                let (a, b) = (self.multiply(a, a), self.multiply(b, b));
                self.add(&a, &b)
            }
            // one of the two, or a mixture of both
            (Function::Min | Function::Max, [a, b]) => {
                let sum = self.add(a, b);
                self.multiply(&sum, &UNKNOWN)
            }
            _ if function.makes_products() => OF_SUM,
            _ => UNKNOWN,
        }
    }

    fn foreign(&mut self, _: Foreign, _: &[Degree; Foreign::ARGUMENTS]) -> Degree {
        UNKNOWN
    }

    fn is_zero(&self, _: &Degree) -> bool {
        false
    }

    fn compare(&mut self, _: Comparison, _: &Degree, _: &Degree) -> Degree {
        UNKNOWN
    }

    fn select(&mut self, condition: &Degree, first: &Degree, second: &Degree) -> Degree {
        let sum = self.add(first, second);
        self.multiply(&sum, condition)
    }
}
