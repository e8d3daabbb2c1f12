//! Partial derivatives, and the chain rule backwards.
//!
//! The nodes are walked in the order in which they were made, children first, without recursion,
//! and the results are built by the simplifying constructors.

use crate::symbolic::algebra::{chain_rule, slope, slopes};
use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::{Function, Number};

impl Graph {
    /// The partial derivatives of `roots` with respect to the symbol `by`.
    ///
    /// Steps (`floor`, `ceil`, `signum`) have the derivative zero, and a choice is differentiated
    /// branch by branch.
    pub fn derivative(&mut self, roots: &[Id], by: Id) -> Vec<Id> {
        let one = self.one();
        self.change(roots, |symbol| (symbol == by).then_some(one))
    }

    /// How `roots` change along with their symbols: `rate` answers for those that do.
    pub fn change(&mut self, roots: &[Id], rate: impl Fn(Id) -> Option<Id>) -> Vec<Id> {
        let order = self.reachable(roots, |_| true);
        let mut changes = vec![None; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let change = if let Node::Symbol(_) = self.node(id) {
                rate(id)
            } else {
                let node = self.node(id).clone();
                chain_rule::change(self, &node, &id, |a| a, |a| changes[a.index()])
            };
            changes[id.index()] = change.filter(|change| !self.is_zero(*change));
        }
        let zero = self.zero();
        roots
            .iter()
            .map(|root| changes[root.index()].unwrap_or(zero))
            .collect()
    }

    /// Where what depends on `id` changes by `weight` for each unit of it, by how much it changes
    /// for each unit of the operands of `id`: one step of the chain rule backwards.
    pub fn pull_back(&mut self, id: Id, weight: Id) -> Vec<(Id, Id)> {
        match *self.node(id) {
            Node::Quantity(a) => vec![(a, weight)],
            Node::Negate(a) => vec![(a, self.negate(weight))],
            Node::Add(a, b) => vec![(a, weight), (b, weight)],
            Node::Subtract(a, b) => vec![(a, weight), (b, self.negate(weight))],
            Node::Multiply(a, b) if a == b => {
                let twice = self.add(weight, weight);
                vec![(a, self.multiply(twice, a))]
            }
            Node::Multiply(a, b) => {
                vec![(a, self.multiply(weight, b)), (b, self.multiply(weight, a))]
            }
            Node::Divide(a, b) => {
                let by_a = self.divide(weight, b);
                let by_b = self.multiply(by_a, id);
                vec![(a, by_a), (b, self.negate(by_b))]
            }
            Node::Unary(Function::Sqrt, a) => {
                let half = self.number(Number::ratio(1, 2));
                let half = self.multiply(half, weight);
                vec![(a, self.divide(half, id))]
            }
            Node::Unary(function, a) => {
                let slope = slope(self, function, &a, &id);
                vec![(a, self.multiply(slope, weight))]
            }
            Node::Binary(function, a, b) => {
                let (by_a, by_b) = slopes(self, function, &a, &b, &id);
                vec![
                    (a, self.multiply(by_a, weight)),
                    (b, self.multiply(by_b, weight)),
                ]
            }
            Node::Select(condition, a, b) => {
                let zero = self.zero();
                vec![
                    (a, self.select(condition, weight, zero)),
                    (b, self.select(condition, zero, weight)),
                ]
            }
            _ => Vec::new(),
        }
    }
}
