//! Differences written as products.
//!
//! Two moments of inertia of a box differ by `m/12 (c^2 - b^2)`. If they are subtracted, the
//! rounding errors of both remain; in `m/12 (c - b) (c + b)`, only those of the edges do
//! (`docs/trust.md`, H2). The same holds for an edge that is a number, if the difference needs more
//! digits than a double has.

use std::collections::BTreeMap;

use crate::symbolic::number::Number;

use super::nodes::{Graph, Id, Node, Stage};

/// A difference that takes more steps than this to multiply out is kept unchanged.
const STEPS: usize = 1000;

/// Factors that are not taken apart any further, with their powers.
type Monomial = BTreeMap<Id, u32>;

/// A term that is being multiplied out.
#[derive(Clone)]
struct Product {
    number: Number,
    pending: Vec<Id>,
    factors: Monomial,
}

impl Graph {
    /// `a - b`. If it is known once the parameters are, it becomes a product, provided that all but
    /// one term or two squares cancel.
    pub fn difference(&mut self, a: Id, b: Id) -> Id {
        let is_early = self.stage(a).max(self.stage(b)) == Stage::Parameter;
        let factored = is_early.then(|| self.difference_as_product(a, b)).flatten();
        factored.unwrap_or_else(|| self.subtract(a, b))
    }

    fn difference_as_product(&mut self, a: Id, b: Id) -> Option<Id> {
        let terms = self.multiplied_out(a, b)?;
        let mut left = terms.into_iter().filter(|(_, number)| !number.is_zero());
        let (x, factor) = left.next()?;
        let Some((y, opposite)) = left.next() else {
            // all other terms cancel
            let (x, factor) = (self.monomial(&x), self.number(factor));
            return Some(self.multiply(factor, x));
        };
        if left.next().is_some() {
            return None;
        }
        let common = shared(&x, &y);
        let first = (root(&x, &common)?, factor);
        let second = (root(&y, &common)?, opposite);
        // factor common (x^2 - (scale y)^2), with numbers last
        let ((x, factor), (y, opposite)) = if first.0.is_empty() {
            (second, first)
        } else {
            (first, second)
        };
        let scale = (-opposite).checked_div(&factor)?.exact_root(2)?;
        let [x, y, common] = [x, y, common].map(|monomial| self.monomial(&monomial));
        let (scale, factor) = (self.number(scale), self.number(factor));
        let y = self.multiply(scale, y);
        let (difference, sum) = (self.apart(x, y), self.add(x, y));
        let scale = self.multiply(factor, common);
        let product = self.multiply(difference, sum);
        Some(self.multiply(scale, product))
    }

    /// `x - y`. If y is a number, its nearest double is subtracted first and the remainder last.
    fn apart(&mut self, x: Id, y: Id) -> Id {
        let Some(number) = self.as_number(y).cloned() else {
            return self.subtract(x, y);
        };
        let nearest = Number::from_f64(number.to_f64());
        let [nearest, rest] = [nearest.clone(), number - nearest].map(|part| self.number(part));
        let difference = self.subtract(x, nearest);
        if self.is_zero(rest) {
            return difference;
        }
        let difference = self.quantity(difference);
        self.subtract(difference, rest)
    }

    /// `a - b` as a sum of products.
    fn multiplied_out(&self, a: Id, b: Id) -> Option<BTreeMap<Monomial, Number>> {
        let term = |number: Number, of: Id| Product {
            number,
            pending: vec![of],
            factors: Monomial::new(),
        };
        let mut products = vec![term(Number::one(), a), term(-Number::one(), b)];
        let mut terms = BTreeMap::new();
        for _ in 0..STEPS {
            let Some(mut product) = products.pop() else {
                return Some(terms);
            };
            let Some(factor) = product.pending.pop() else {
                let sum = terms.entry(product.factors).or_insert_with(Number::zero);
                *sum = sum.clone() + product.number;
                continue;
            };
            match *self.node(factor) {
                Node::Number(ref value) => product.number = product.number * value.clone(),
                Node::Negate(x) => {
                    product.number = -product.number;
                    product.pending.push(x);
                }
                Node::Multiply(x, y) => product.pending.extend([x, y]),
                Node::Add(x, y) => {
                    let mut second = product.clone();
                    second.pending.push(y);
                    products.push(second);
                    product.pending.push(x);
                }
                Node::Subtract(x, y) => {
                    let mut second = product.clone();
                    second.number = -second.number;
                    second.pending.push(y);
                    products.push(second);
                    product.pending.push(x);
                }
                _ => *product.factors.entry(factor).or_insert(0) += 1,
            }
            products.push(product);
        }
        None
    }

    fn monomial(&mut self, factors: &Monomial) -> Id {
        let mut product = self.one();
        for (factor, power) in factors {
            for _ in 0..*power {
                product = self.multiply(product, *factor);
            }
        }
        product
    }
}

/// The factors that both contain.
fn shared(x: &Monomial, y: &Monomial) -> Monomial {
    let both = x.iter().filter_map(|(factor, power)| {
        let power = power.min(y.get(factor)?);
        Some((*factor, *power))
    });
    both.collect()
}

/// The square root of what remains of a product without the factors `beside`.
fn root(x: &Monomial, beside: &Monomial) -> Option<Monomial> {
    let rest = x
        .iter()
        .map(|(factor, power)| (factor, power - beside.get(factor).unwrap_or(&0)));
    rest.filter(|(_, rest)| *rest > 0)
        .map(|(factor, rest)| rest.is_multiple_of(2).then_some((*factor, rest / 2)))
        .collect()
}
