//! Differences that are written as products.
//!
//! Two moments of inertia of a box differ by `m/12 (c^2 - b^2)`. Subtracted one from the other, they leave the rounding of
//! both; as `m/12 (c - b) (c + b)`, that of the edges (`docs/trust.md`, H2).

use std::collections::BTreeMap;

use super::graph::{Graph, Id, Node, Stage};
use super::number::Number;

/// A difference that takes more steps than these to multiply out is taken as it stands.
const STEPS: usize = 1000;

/// Factors that are not looked into, with their powers.
type Monomial = BTreeMap<Id, u32>;

/// A term that is being multiplied out.
#[derive(Clone)]
struct Product {
    number: Number,
    pending: Vec<Id>,
    factors: Monomial,
}

impl Graph {
    /// `a - b`, known once the parameters are: a product, if it is a difference of two squares.
    pub fn difference(&mut self, a: Id, b: Id) -> Id {
        let is_early = self.stage(a).max(self.stage(b)) == Stage::Parameter;
        let factored = is_early.then(|| self.difference_of_squares(a, b)).flatten();
        factored.unwrap_or_else(|| self.subtract(a, b))
    }

    fn difference_of_squares(&mut self, a: Id, b: Id) -> Option<Id> {
        let terms = self.multiplied_out(a, b)?;
        let mut left = terms.into_iter().filter(|(_, number)| !number.is_zero());
        let ((x, factor), (y, opposite)) = (left.next()?, left.next()?);
        if left.next().is_some() || factor != -opposite {
            return None;
        }
        let common = shared(&x, &y);
        let [x, y] = [root(&x, &common)?, root(&y, &common)?];
        let [x, y, common] = [x, y, common].map(|monomial| self.monomial(&monomial));
        let (difference, sum) = (self.subtract(x, y), self.add(x, y));
        let factor = self.number(factor);
        let scale = self.multiply(factor, common);
        let product = self.multiply(difference, sum);
        Some(self.multiply(scale, product))
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

/// The factors of both.
fn shared(x: &Monomial, y: &Monomial) -> Monomial {
    let both = x.iter().filter_map(|(factor, power)| {
        let power = power.min(y.get(factor)?);
        Some((*factor, *power))
    });
    both.collect()
}

/// The root of what a product has beside those factors.
fn root(x: &Monomial, beside: &Monomial) -> Option<Monomial> {
    let rest = x.iter().map(|(factor, power)| {
        let rest = power - beside.get(factor).unwrap_or(&0);
        rest.is_multiple_of(2).then_some((*factor, rest / 2))
    });
    rest.collect()
}
