//! Partial derivatives.
//!
//! Nodes are visited in the order in which they were made, children first, without recursion. The
//! simplifying constructors build the results.

use crate::symbolic::algebra::chain_rule;
use crate::symbolic::graph::{Graph, Id};

impl Graph {
    /// The partial derivatives of `roots` with respect to the symbol `by`.
    ///
    /// Step functions (`floor`, `ceil`, `signum`) have the derivative zero, and a choice is
    /// differentiated branch by branch.
    pub fn derivative(&mut self, roots: &[Id], by: Id) -> Vec<Id> {
        let one = self.one();
        self.change(roots, |symbol| (symbol == by).then_some(one))
    }

    /// The changes of `roots`, given the changes of some expressions: `rate` gives them for
    /// symbols, and for expressions whose operands are not visited.
    pub fn change(&mut self, roots: &[Id], rate: impl Fn(Id) -> Option<Id>) -> Vec<Id> {
        let order = self.reachable(roots, &|id| rate(id).is_none());
        let mut changes = vec![None; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let change = rate(id).or_else(|| {
                let node = self.node(id).clone();
                chain_rule::change(self, &node, &id, |a| a, |a| changes[a.index()])
            });
            changes[id.index()] = change.filter(|change| !self.is_zero(*change));
        }
        let zero = self.zero();
        roots
            .iter()
            .map(|root| changes[root.index()].unwrap_or(zero))
            .collect()
    }
}
