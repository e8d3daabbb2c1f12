//! The recurrences of a series: products, sums, and their results, level by level.

use crate::symbolic::graph::Id;

use super::convolution::Sum;

/// A coordinate of a motion.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    pub symbol: Id,
    pub rate: Id,
}

/// A symbol with given motion: its coefficients from order 1 on, which are constant along a step.
#[derive(Clone, Debug)]
pub struct Polynomial {
    pub symbol: Id,
    pub coefficients: Vec<Id>,
}

/// The coefficients of a motion, order by order.
#[derive(Debug)]
pub struct Recurrences {
    /// The symbols of the n-th coefficients of the coordinates.
    pub coefficients: Vec<Id>,
    /// The symbols with given motion, each with the symbol of its n-th coefficient.
    pub polynomials: Vec<(Polynomial, Id)>,
    /// The symbols of n and 1/n.
    pub order: Id,
    pub inverse: Id,
    /// The n-th coefficients of quotients and functions.
    pub results: Vec<(Id, Id)>,
    /// The convolutions, by level: the factors of one level are made from lower levels.
    pub sums: Vec<Sum>,
    /// The rates of the coordinates at the start, and their n-th coefficients.
    pub start: Vec<Id>,
    pub rates: Vec<Id>,
}

impl Recurrences {
    /// All expressions that code is generated for.
    pub fn roots(&self) -> Vec<Id> {
        let terms = self.sums.iter().flat_map(|sum| &sum.terms);
        let factors = terms.flat_map(|term| {
            let [left, right] = term.factors;
            [term.weight, left.start, left.next, right.start, right.next]
        });
        let linear = self.sums.iter().flat_map(|sum| &sum.linear);
        self.start
            .iter()
            .chain(&self.rates)
            .copied()
            .chain(factors)
            .chain(linear.flat_map(|(weight, next)| [*weight, *next]))
            .collect()
    }
}
