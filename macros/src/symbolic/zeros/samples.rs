//! Whether an expression is zero: the one test of the compiler.
//!
//! An expression is called *zero* if it is proved to be zero in all states, on all branches, for
//! both signs of every root and at all scales: see [`super::identity`]. All others may be zero
//! somewhere or everywhere, and are treated as nonzero. Floating-point values prove nothing, at any
//! precision.

use std::collections::HashSet;

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::Residue;

use super::branches::{MOST_CHOICES, on_branches};
use super::identity::{Residues, Side};

/// The value of an expression at one random place, on each branch; `None` where it has none.
#[derive(Clone, PartialEq)]
pub struct Sample(pub Vec<Option<Residue>>);

impl Sample {
    /// Zero on each of the same branches.
    pub fn nothing(&self) -> Self {
        Self(vec![Some(Residue::ZERO); self.0.len()])
    }

    /// Whether it is proved to be zero on every branch.
    pub fn is_zero(&self) -> bool {
        self.0
            .iter()
            .all(|value| value.is_some_and(Residue::is_zero))
    }

    /// Whether it is nonzero somewhere.
    pub fn is_refuted(&self) -> bool {
        self.0
            .iter()
            .any(|value| value.is_some_and(|value| !value.is_zero()))
    }

    /// Whether it is nonzero on each branch that is tried: enough to prefer one divisor to others, and
    /// no proof.
    pub fn is_nonzero_where_tried(&self) -> bool {
        let is_nonzero = |value: &Option<Residue>| value.is_some_and(|value| !value.is_zero());
        self.0.iter().all(is_nonzero)
    }

    /// `self / divisor`
    pub fn over(&self, divisor: &Self) -> Self {
        self.with(divisor, |a, b| Some(a * b.reciprocal()?))
    }

    /// `self * factor`
    pub fn times(&self, factor: &Self) -> Self {
        self.with(factor, |a, b| Some(a * b))
    }

    /// `self + other`
    pub fn plus(&self, other: &Self) -> Self {
        self.with(other, |a, b| Some(a + b))
    }

    /// `self - other`
    pub fn minus(&self, other: &Self) -> Self {
        self.with(other, |a, b| Some(a + -b))
    }

    fn with(&self, other: &Self, of: impl Fn(Residue, Residue) -> Option<Residue>) -> Self {
        if self.0.len() != other.0.len() {
            // of different branches
            return Self(vec![None]);
        }
        let pairs = self.0.iter().zip(&other.0);
        Self(pairs.map(|(a, b)| of((*a)?, (*b)?)).collect())
    }
}

impl Graph {
    /// The values of `roots` for random values of the symbols.
    pub fn samples(&self, roots: &[Id], symbol: impl Fn(Id) -> Residue) -> Vec<Sample> {
        self.sums(roots, &[symbol])
    }

    /// The sums of the values of `roots` at several places.
    pub fn sums(&self, roots: &[Id], places: &[impl Fn(Id) -> Residue]) -> Vec<Sample> {
        self.sums_with(0, roots, places)
    }

    /// Whether an expression may be zero everywhere on some branch, or on a piece of a function: of
    /// branches that are not tried nothing is known, nor of the values on each piece.
    pub fn may_vanish(&self, root: Id, symbol: impl Fn(Id) -> Residue) -> bool {
        let of = |pieces| self.sums_with(pieces, &[root], &[&symbol]).pop();
        let [sample, other] = [0, 1].map(of);
        let are_all_tried = |sample: &Sample| sample.0.len() <= 1 << MOST_CHOICES;
        let is_nonzero = |sample: &Sample| are_all_tried(sample) && sample.is_nonzero_where_tried();
        !sample.as_ref().is_some_and(is_nonzero) || sample != other
    }

    /// The sums, with one of several sets of values of functions that are made of pieces.
    fn sums_with(
        &self,
        pieces: u8,
        roots: &[Id],
        places: &[impl Fn(Id) -> Residue],
    ) -> Vec<Sample> {
        let tape = self.tape(roots);
        if !tape.has_small_degree() {
            return vec![Sample(vec![None]); roots.len()];
        }
        let branches = on_branches(|residues| {
            residues.pieces = pieces;
            let mut sums = vec![Some(Residue::ZERO); roots.len()];
            for symbol in places {
                let values = tape.values(residues, |_, id| Some(symbol(id)));
                for (sum, root) in sums.iter_mut().zip(roots) {
                    *sum = sum.zip(*tape.of(&values, *root)).map(|(a, b)| a + b);
                }
            }
            sums
        });
        let of = |index: usize| Sample(branches.iter().map(|values| values[index]).collect());
        (0..roots.len()).map(of).collect()
    }

    /// Whether each of `roots` is zero, if one or two evaluations decide it; `None` if all branches
    /// must be tried. A root that is nonzero on the first branch is not zero. If there are too many
    /// branches to try all of them, a root is zero if it is zero on the first, and with symbols for all
    /// choices.
    pub fn decided_at_once(
        &self,
        roots: &[Id],
        symbol: impl Fn(Id) -> Residue,
    ) -> Vec<Option<bool>> {
        let tape = self.tape(roots);
        let values_on = |side: &mut dyn FnMut(Side) -> Option<bool>| {
            let values = tape.values(&mut Residues::new(side), |_, id| Some(symbol(id)));
            let values = roots.iter().map(|root| *tape.of(&values, *root));
            values.collect::<Vec<Option<Residue>>>()
        };
        let mut choices = HashSet::new();
        let first = values_on(&mut |side| {
            choices.insert(side);
            Some(false)
        });
        let is_nonzero = |value: &Option<Residue>| value.is_some_and(|value| !value.is_zero());
        let are_many = choices.len() > MOST_CHOICES && !first.iter().all(is_nonzero);
        let is_told = are_many && tape.has_small_degree();
        let mixed = is_told.then(|| values_on(&mut |_| None));
        let told = first.iter().enumerate().map(|(index, first)| {
            let is_zero = |mixed: &Vec<_>| [*first, mixed[index]] == [Some(Residue::ZERO); 2];
            if is_nonzero(first) {
                Some(false)
            } else {
                mixed.as_ref().is_some_and(is_zero).then_some(true)
            }
        });
        told.collect()
    }

    /// Whether an expression is proved to be zero, whatever its symbols are.
    pub fn vanishes(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Number(number) => number.is_zero(),
            Node::Symbol(_) => false,
            _ => {
                let symbol = |id| free(id, 0);
                let told = self.decided_at_once(&[id], symbol)[0];
                told.unwrap_or_else(|| self.samples(&[id], symbol)[0].is_zero())
            }
        }
    }
}

/// A random value of a free symbol at the place with this number.
pub fn free(symbol: Id, place: u64) -> Residue {
    Residue::stand_in(&("symbol", symbol, place))
}
