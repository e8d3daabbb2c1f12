//! Values modulo a prime: an expression that is zero at a random place is zero identically.
//!
//! Symbols have random residues. Values of functions have random residues too, the same for equal
//! arguments. Sines, hyperbolic functions and exponentials of a sum of multiples are products of
//! powers ([`super::powers`]): sines follow from the tangents of half the angles of its terms, and
//! hyperbolic functions from exponentials. Any other function has its own values. An irrational
//! number carries its residue along ([`crate::symbolic::number::irrational`]). A root has both
//! signs, and a condition both outcomes: each is a separate branch. A root of a root may have no
//! residue, and is then random too.
//!
//! An expression that is zero at this place on every branch is zero in all states, for all
//! functions with these properties, except with probability `degree / PRIME` (J. Schwartz, Fast
//! probabilistic algorithms for verification of polynomial identities, J. ACM 27, 1980, 701; R.
//! Zippel, Probabilistic algorithms for sparse polynomials, EUROSAM 1979). An expression that is
//! nonzero there may still be zero: `ln x^2 - 2 ln x` for positive x.

use std::collections::HashMap;

use crate::symbolic::algebra::{Algebra, Multiples};
use crate::symbolic::graph::Comparison;
use crate::symbolic::number::{Foreign, Function, Number, Residue};

use super::powers::Powers;

/// Residues on one branch; `None` stands for a quotient by zero.
pub struct Residues<'a> {
    side: &'a mut dyn FnMut(Side) -> Option<bool>,
    /// Selects the random values of functions that are made of pieces.
    pub pieces: u8,
    /// The sums that arguments of functions are.
    sums: HashMap<Residue, Powers>,
}

impl<'a> Residues<'a> {
    /// Residues on the branch given by `side`. A choice without an answer becomes a symbol.
    pub(in crate::symbolic) fn new(side: &'a mut dyn FnMut(Side) -> Option<bool>) -> Self {
        Self {
            side,
            pieces: 0,
            sums: HashMap::new(),
        }
    }

    /// The sum that an argument is.
    fn powers(&self, argument: Residue) -> Powers {
        let known = self.sums.get(&argument).cloned();
        let turned = || self.sums.get(&-argument).map(Powers::negated);
        let powers = known.or_else(turned);
        powers.unwrap_or_else(|| Powers::single(argument))
    }

    /// A sine, a cosine or a tangent.
    fn on_circle(&self, function: Function, angle: Residue) -> Option<Residue> {
        let half_tangent = |base| Self::odd(Function::Tan, base);
        let [cosine, sine] = self.powers(angle).on_circle(half_tangent)?;
        match function {
            Function::Sin => Some(sine),
            Function::Cos => Some(cosine),
            _ => Some(sine * cosine.reciprocal()?),
        }
    }

    /// A hyperbolic function, by the exponential of its argument.
    fn on_hyperbola(&self, function: Function, a: Residue) -> Option<Residue> {
        let grown = self.exponential(a)?;
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

    /// `e^a`
    fn exponential(&self, a: Residue) -> Option<Residue> {
        self.powers(a).exponential(|base| {
            let (size, is_turned) = base.unsigned();
            let grown = Residue::stand_in(&(Function::Exp, size));
            if is_turned {
                grown.reciprocal()
            } else {
                Some(grown)
            }
        })
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

    /// A square root, of either sign.
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

    /// Whether a number is negative: one, zero, or a symbol.
    fn is_below_zero(&mut self, a: Residue) -> Residue {
        if a.is_zero() {
            return Residue::ZERO;
        }
        match (self.side)(Side::Below(a)) {
            Some(holds) => Residue::real(u128::from(holds)),
            None => Residue::stand_in(&("below", a)),
        }
    }

    /// Whether a number is zero: one, zero, or a symbol.
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
            (Function::Sin | Function::Cos | Function::Tan, [a]) => self.on_circle(function, *a),
            (Function::Sinh | Function::Cosh | Function::Tanh, [a]) => {
                self.on_hyperbola(function, *a)
            }
            (Function::Exp, [a]) => self.exponential(*a),
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
            _ if function.is_piecewise() => {
                Some(Residue::stand_in(&(function, arguments, self.pieces)))
            }
            _ => Some(Residue::stand_in(&(function, arguments))),
        }
    }

    fn foreign(
        &mut self,
        function: Foreign,
        [a, b, c]: &[Option<Residue>; Foreign::ARGUMENTS],
    ) -> Option<Residue> {
        let arguments = [(*a)?, (*b)?, (*c)?];
        Some(Residue::stand_in(&(function, arguments, self.pieces)))
    }

    fn is_zero(&self, a: &Option<Residue>) -> bool {
        *a == Some(Residue::ZERO)
    }

    fn know_sum(
        &mut self,
        argument: &Option<Residue>,
        sum: impl FnOnce() -> Option<Multiples<Option<Residue>>>,
    ) {
        if let Some(argument) = *argument
            && !self.sums.contains_key(&argument)
        {
            let powers = sum().and_then(Powers::of);
            let powers = powers.unwrap_or_else(|| Powers::single(argument));
            self.sums.insert(argument, powers);
        }
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

/// A choice, identified by the values that it depends on: equal values give equal choices.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::symbolic) enum Side {
    /// The sign of the root of this.
    Root(Residue),
    /// Whether this is below zero.
    Below(Residue),
    /// Whether this is zero.
    Nothing(Residue),
}
