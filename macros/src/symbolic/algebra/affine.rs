//! Expressions that are sums of symbols, each with a factor that is known early.

use std::collections::{BTreeMap, BTreeSet};

use crate::symbolic::graph::{Graph, Id, Node};

/// An early term, and the early factor of each symbol.
#[derive(Clone)]
struct Affine {
    constant: Id,
    factors: BTreeMap<Id, Id>,
}

impl Graph {
    /// The root as such a sum, if it consists of sums and early factors alone. Products are
    /// multiplied out: `a * (b * x + c * y)` becomes `(a * b) * x + (a * c) * y`.
    pub fn affine(&mut self, root: Id) -> Option<Id> {
        if !self.is_affine(root) {
            return None;
        }
        let mut known: BTreeMap<Id, Affine> = BTreeMap::new();
        for id in self.reachable(&[root], &|id| !self.is_early(id)) {
            let affine = self.affine_node(id, &known)?;
            known.insert(id, affine);
        }
        let Affine { constant, factors } = known.remove(&root)?;
        let terms = factors.into_iter();
        let mut terms: Vec<Id> = terms
            .map(|(symbol, factor)| self.multiply(factor, symbol))
            .collect();
        terms.push(constant);
        Some(self.sum(&terms))
    }

    /// Whether each root is a sum of the symbols by its form, each with a factor without them, and
    /// of a rest without them.
    pub fn is_linear(&self, roots: &[Id], symbols: &[Id]) -> bool {
        let mut degrees: BTreeMap<Id, usize> = BTreeMap::new();
        for id in self.nodes_of(roots) {
            let degree = |a: &Id| degrees.get(a).copied().unwrap_or(0);
            let own = match self.node(id) {
                Node::Symbol(_) => usize::from(symbols.contains(&id)),
                Node::Add(a, b) | Node::Subtract(a, b) => degree(a).max(degree(b)),
                Node::Multiply(a, b) => degree(a) + degree(b),
                Node::Negate(a) | Node::Quantity(a) => degree(a),
                Node::Divide(a, b) if degree(b) == 0 => degree(a),
                Node::Select(condition, a, b) if degree(condition) == 0 => degree(a).max(degree(b)),
                other => {
                    let depends = other.operands().any(|operand| degree(&operand) > 0);
                    2 * usize::from(depends)
                }
            };
            degrees.insert(id, own.min(2));
        }
        roots.iter().all(|root| degrees[root] < 2)
    }

    /// Whether the root consists of sums, symbols and early factors alone.
    fn is_affine(&self, root: Id) -> bool {
        let (mut pending, mut seen) = (vec![root], BTreeSet::new());
        while let Some(id) = pending.pop() {
            if self.is_early(id) || !seen.insert(id) {
                continue;
            }
            match *self.node(id) {
                Node::Symbol(_) => {}
                Node::Quantity(a) | Node::Negate(a) => pending.push(a),
                Node::Add(a, b) | Node::Subtract(a, b) => pending.extend([a, b]),
                Node::Multiply(a, b) if self.is_early(a) => pending.push(b),
                Node::Multiply(a, b) if self.is_early(b) => pending.push(a),
                _ => return false,
            }
        }
        true
    }

    fn affine_node(&mut self, id: Id, known: &BTreeMap<Id, Affine>) -> Option<Affine> {
        if self.is_early(id) {
            return Some(Affine {
                constant: id,
                factors: BTreeMap::new(),
            });
        }
        let (one, minus_one) = (self.one(), self.integer(-1));
        match *self.node(id) {
            Node::Symbol(_) => Some(Affine {
                constant: self.zero(),
                factors: BTreeMap::from([(id, one)]),
            }),
            Node::Quantity(a) => known.get(&a).cloned(),
            Node::Negate(a) => Some(self.scaled(known.get(&a)?, minus_one)),
            Node::Add(a, b) => Some(self.with(known.get(&a)?, known.get(&b)?, one)),
            Node::Subtract(a, b) => Some(self.with(known.get(&a)?, known.get(&b)?, minus_one)),
            Node::Multiply(a, b) if self.is_early(a) => Some(self.scaled(known.get(&b)?, a)),
            Node::Multiply(a, b) => Some(self.scaled(known.get(&a)?, b)),
            _ => None,
        }
    }

    fn scaled(&mut self, affine: &Affine, factor: Id) -> Affine {
        let factors = affine.factors.iter();
        Affine {
            constant: self.multiply(factor, affine.constant),
            factors: factors
                .map(|(symbol, own)| (*symbol, self.multiply(factor, *own)))
                .collect(),
        }
    }

    /// `first + factor * second`
    fn with(&mut self, first: &Affine, second: &Affine, factor: Id) -> Affine {
        let second = self.scaled(second, factor);
        let mut sum = first.clone();
        sum.constant = self.add(sum.constant, second.constant);
        for (symbol, more) in second.factors {
            let zero = self.zero();
            let own = sum.factors.entry(symbol).or_insert(zero);
            *own = self.add(*own, more);
        }
        sum
    }
}
