//! Expressions as sums of multiples of others.

use std::collections::BTreeMap;

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::Number;

/// The most terms of a sum that is taken apart.
const MOST_TERMS: usize = 16;

/// `constant + sum of factor * value`
pub struct Multiples<V> {
    pub constant: Number,
    pub terms: Vec<(V, Number)>,
}

impl<V> Multiples<V> {
    /// The same sum of other values.
    pub fn map<W>(self, of: impl Fn(V) -> W) -> Multiples<W> {
        let terms = self.terms.into_iter();
        Multiples {
            constant: self.constant,
            terms: terms.map(|(value, factor)| (of(value), factor)).collect(),
        }
    }
}

impl Graph {
    /// An expression as such a sum, by its form; `None` if it has many terms.
    pub fn multiples(&self, root: Id) -> Option<Multiples<Id>> {
        let (mut constant, mut terms) = (Number::zero(), BTreeMap::new());
        let mut pending = vec![(root, Number::one())];
        while let Some((id, factor)) = pending.pop() {
            if pending.len() + terms.len() >= MOST_TERMS {
                return None;
            }
            let mut term = |factor: Number| {
                let sum = terms.entry(id).or_insert_with(Number::zero);
                *sum = sum.clone() + factor;
            };
            let multiple = |of: Id, number: Id| Some((of, self.as_number(number)?.clone()));
            match *self.node(id) {
                Node::Number(ref number) => constant = constant + factor * number.clone(),
                Node::Quantity(a) => pending.push((a, factor)),
                Node::Negate(a) => pending.push((a, -factor)),
                Node::Add(a, b) => pending.extend([(a, factor.clone()), (b, factor)]),
                Node::Subtract(a, b) => pending.extend([(a, factor.clone()), (b, -factor)]),
                Node::Multiply(a, b) => match multiple(a, b).or_else(|| multiple(b, a)) {
                    Some((of, number)) => pending.push((of, factor * number)),
                    None => term(factor),
                },
                Node::Divide(a, b) => {
                    let number = self.as_number(b);
                    match number.and_then(|number| factor.checked_div(number)) {
                        Some(factor) => pending.push((a, factor)),
                        None => term(factor),
                    }
                }
                _ => term(factor),
            }
        }
        terms.retain(|_, factor| !factor.is_zero());
        Some(Multiples {
            constant,
            terms: terms.into_iter().collect(),
        })
    }
}
