//! The sizes of the terms that a value sums: what its residual is compared with where it should be
//! zero.

use crate::symbolic::algebra::{slope, slopes, takes_first};
use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::Function;

impl Graph {
    /// For each root, the size of the largest term in any of its sums, as much as it contributes to
    /// the root to first order. Times the rounding unit, this estimates the rounding error (running
    /// error analysis, without its sums: N. Higham, Accuracy and Stability of Numerical
    /// Algorithms, 3.3). Divisors count as given, so that the size stays small where one vanishes;
    /// so do tables and foreign functions.
    pub fn magnitudes(&mut self, roots: &[Id]) -> Vec<Id> {
        let order = self.nodes_of(roots);
        let mut sizes = vec![None; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let size = self.magnitude(id, |operand| sizes[operand.index()]);
            sizes[id.index()] = size.filter(|size| !self.is_undefined(*size));
        }
        let roots = roots.iter();
        roots
            .map(|root| sizes[root.index()].unwrap_or_else(|| self.size_of(*root)))
            .collect()
    }

    /// The size of one node, given those of its operands; `None` if it contains no sum.
    fn magnitude(&mut self, id: Id, sums: impl Fn(Id) -> Option<Id>) -> Option<Id> {
        let node = self.node(id).clone();
        let is_sum = matches!(node, Node::Add(..) | Node::Subtract(..));
        if !is_sum && node.operands().all(|operand| sums(operand).is_none()) {
            return None;
        }
        match node {
            Node::Quantity(a)
            | Node::Positive(a)
            | Node::Negate(a)
            | Node::Unary(Function::Abs, a) => sums(a),
            Node::Add(a, b) | Node::Subtract(a, b) | Node::Binary(Function::Hypot, a, b) => {
                let [a, b] = [a, b].map(|one| sums(one).unwrap_or_else(|| self.size_of(one)));
                Some(self.apply(Function::Max, &[a, b]))
            }
            Node::Multiply(a, b) => self.passed_on([(sums(a), b), (sums(b), a)]),
            Node::Divide(a, b) => {
                let (a, b) = (sums(a)?, self.size_of(b));
                Some(self.divide(a, b))
            }
            // the slope of a root at zero has no value
            Node::Unary(function @ (Function::Sqrt | Function::Cbrt), a) => {
                Some(self.apply(function, &[sums(a)?]))
            }
            Node::Unary(function, a) => {
                let slope = slope(self, function, &a, &id);
                self.with_value(id, [(sums(a), slope)])
            }
            Node::Binary(Function::Table, ..) => None,
            Node::Binary(function @ (Function::Min | Function::Max), a, b) => {
                let first = takes_first(self, function, &a, &b);
                Some(self.chosen_size(first, [a, b], sums))
            }
            Node::Select(condition, a, b) => Some(self.chosen_size(condition, [a, b], sums)),
            Node::Binary(function, a, b) => {
                let (by_a, by_b) = slopes(self, function, &a, &b, &id);
                self.with_value(id, [(sums(a), by_a), (sums(b), by_b)])
            }
            _ => None,
        }
    }

    fn size_of(&mut self, value: Id) -> Id {
        self.apply(Function::Abs, &[value])
    }

    /// The largest of some sizes, each multiplied by the size of a factor.
    fn passed_on<const N: usize>(&mut self, parts: [(Option<Id>, Id); N]) -> Option<Id> {
        let parts = parts.map(|(size, factor)| {
            let factor = self.size_of(factor);
            size.map(|size| self.multiply(size, factor))
        });
        let parts = parts.into_iter().flatten();
        parts.reduce(|a, b| self.apply(Function::Max, &[a, b]))
    }

    /// The same for the operands of a function, no less than its value.
    fn with_value<const N: usize>(&mut self, id: Id, by: [(Option<Id>, Id); N]) -> Option<Id> {
        let (passed, own) = (self.passed_on(by)?, self.size_of(id));
        Some(self.apply(Function::Max, &[passed, own]))
    }

    /// The size of the chosen one of two.
    fn chosen_size(
        &mut self,
        condition: Id,
        branches: [Id; 2],
        sums: impl Fn(Id) -> Option<Id>,
    ) -> Id {
        let [a, b] = branches.map(|one| sums(one).unwrap_or_else(|| self.size_of(one)));
        self.select(condition, a, b)
    }
}
