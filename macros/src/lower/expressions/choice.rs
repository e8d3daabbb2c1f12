//! Choices between two values by a condition.

use crate::syntax::Expression;

use super::lowering::{Lowering, dimension};
use super::value::Value;

impl Lowering<'_> {
    pub fn choice(&mut self, [condition, first, second]: &[Expression; 3]) -> Option<Value> {
        let (chosen_by, a, b) = (self.value(condition), self.value(first), self.value(second));
        let Value::Condition(chosen_by) = chosen_by? else {
            return self.report(condition.extent, "expected a condition, such as `t < 1[s]`");
        };
        let (a, b) = (a?, b?);
        let (Some(of_a), Some(of_b)) = (dimension(a), dimension(b)) else {
            let (wrong, branch) = if dimension(a).is_none() {
                (a, first)
            } else {
                (b, second)
            };
            return self.report(
                branch.extent,
                format!(
                    "a branch is a scalar or a vector, and this is {}",
                    wrong.kind()
                ),
            );
        };
        let Some(dimension) = of_a.unify(of_b) else {
            let (branch, this, other) = if first.size() < second.size() {
                (first, of_a, of_b)
            } else {
                (second, of_b, of_a)
            };
            let place = self.culprit(branch, other);
            let (this, other) = (this.described(), other.described());
            return self.report(
                place,
                format!(
                    "both branches have one dimension: this is {this}, and the other is {other}"
                ),
            );
        };
        let graph = &mut self.work.graph;
        if let (Value::Scalar(a, _), Value::Scalar(b, _)) = (a, b) {
            return Some(Value::Scalar(graph.select(chosen_by, a, b), dimension));
        }
        let (Some(a), Some(b)) = (self.as_vector(a), self.as_vector(b)) else {
            return self.report(
                second.extent,
                "both branches are scalars, or both are vectors",
            );
        };
        let chosen = self.work.combine(&[a, b], |graph, parts| {
            [0, 1, 2].map(|i| graph.select(chosen_by, parts[0][i], parts[1][i]))
        });
        Some(Value::Vector(chosen, dimension))
    }
}
