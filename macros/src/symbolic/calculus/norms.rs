//! Norms where they are zero. There a norm has no slope, but a product with it may have one:
//! quadratic drag `|v| v` has the slope zero at rest. So a norm gets the slope zero where it is
//! zero.
//!
//! A norm that is a divisor is unchanged: where it is zero, the quotient has no value.

use std::collections::HashSet;

use crate::symbolic::graph::{Comparison, Graph, Id, Node};
use crate::symbolic::number::Function;

impl Graph {
    /// The same expressions, rewritten so that the slopes of their norms are zero where the norms
    /// are.
    pub fn level_norms(&mut self, roots: &[Id], is_leaf: impl Fn(Id) -> bool) -> Vec<Id> {
        let divisors = self.divisors(roots, &is_leaf);
        self.rebuild(roots, |graph, id, image| {
            if is_leaf(id) || graph.is_early(id) {
                return id;
            }
            let same = graph.remake(id, image);
            if divisors.contains(&id) || !graph.is_norm(id, &divisors) {
                return same;
            }
            let zero = graph.zero();
            let is_zero = graph.compare(Comparison::Equal, same, zero);
            graph.select(is_zero, zero, same)
        })
    }

    /// Whether this is a norm that divides nothing: a hypotenuse, or the root of an expression that
    /// is nonnegative and may be zero.
    fn is_norm(&self, id: Id, divisors: &HashSet<Id>) -> bool {
        match *self.node(id) {
            Node::Unary(Function::Sqrt, a) => !divisors.contains(&a) && self.may_touch_zero(a),
            Node::Binary(Function::Hypot, ..) => true,
            _ => false,
        }
    }

    /// All factors of divisors.
    fn divisors(&self, roots: &[Id], is_leaf: impl Fn(Id) -> bool) -> HashSet<Id> {
        let all = self.reachable(roots, &|id| !is_leaf(id)).into_iter();
        let divisors = all.filter_map(|id| match *self.node(id) {
            Node::Divide(_, divisor) => Some(divisor),
            _ => None,
        });
        let divisors: Vec<Id> = divisors.collect();
        let is_product = |id: Id| matches!(self.node(id), Node::Quantity(_) | Node::Multiply(..));
        self.reachable(&divisors, &is_product).into_iter().collect()
    }
}
