//! Expressions in the order of computation, to be evaluated at many states.

use crate::symbolic::graph::{Graph, Id, Node};

use super::chain_rule;
use super::operations::{self, Algebra};

/// All parts of some roots, children first.
pub struct Tape<'a> {
    graph: &'a Graph,
    order: Vec<Id>,
    /// The place of each expression in the order.
    place: Vec<u32>,
}

impl Graph {
    pub fn tape(&self, roots: &[Id]) -> Tape<'_> {
        let order = self.nodes_of(roots);
        let mut place = vec![0; order.last().map_or(0, |last| last.index() + 1)];
        for (index, id) in order.iter().enumerate() {
            place[id.index()] = u32::try_from(index).unwrap_or(u32::MAX);
        }
        Tape {
            graph: self,
            order,
            place,
        }
    }
}

impl Tape<'_> {
    /// The values of all expressions; `symbol` gives those of symbols.
    pub fn values<A: Algebra>(
        &self,
        algebra: &mut A,
        mut symbol: impl FnMut(&mut A, Id) -> A::Value,
    ) -> Vec<A::Value> {
        let mut values: Vec<A::Value> = Vec::with_capacity(self.order.len());
        for &id in &self.order {
            let node = self.graph.node(id);
            if let Node::Unary(function, a) = *node
                && function.makes_products()
            {
                algebra.know_sum(self.of(&values, a), || {
                    let sum = self.graph.multiples(a)?;
                    Some(sum.map(|id| self.of(&values, id).clone()))
                });
            }
            let value = match node {
                Node::Symbol(_) => symbol(algebra, id),
                node => {
                    operations::value(algebra, node, |operand| self.of(&values, operand).clone())
                }
            };
            values.push(value);
        }
        values
    }

    /// The changes of all expressions if symbols change by `rate`; `None` means no change.
    pub fn changes<A: Algebra>(
        &self,
        algebra: &mut A,
        values: &[A::Value],
        rate: impl Fn(Id) -> Option<A::Value>,
    ) -> Vec<Option<A::Value>> {
        let mut changes: Vec<Option<A::Value>> = Vec::with_capacity(self.order.len());
        for (&id, value) in self.order.iter().zip(values) {
            let known = |operand: Id| self.of(values, operand).clone();
            let change = match self.graph.node(id) {
                Node::Symbol(_) => rate(id),
                node => chain_rule::change(algebra, node, value, known, |operand| {
                    self.of(&changes, operand).clone()
                }),
            };
            changes.push(change.filter(|change| !algebra.is_zero(change)));
        }
        changes
    }

    /// The value of an expression, among the values of all.
    pub fn of<'v, V>(&self, all: &'v [V], id: Id) -> &'v V {
        &all[self.place[id.index()] as usize]
    }
}
