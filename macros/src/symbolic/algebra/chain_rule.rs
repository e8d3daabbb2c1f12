//! The chain rule: the change of a node with its operands, for all algebras.

use crate::symbolic::graph::{Id, Node};
use crate::symbolic::number::Function;

use super::operations::Algebra;
use super::slopes::{slope, slopes, takes_first};

/// The change of a node with its operands, one step of the chain rule; `None` is no change.
/// Steps (`floor`, `ceil`, `signum`) do not change, and a choice changes like its branches.
pub fn change<A: Algebra>(
    of: &mut A,
    node: &Node,
    itself: &A::Value,
    known: impl Fn(Id) -> A::Value,
    change: impl Fn(Id) -> Option<A::Value>,
) -> Option<A::Value> {
    if node.operands().all(|operand| change(operand).is_none()) {
        return None;
    }
    let d = |operand: Id| change(operand);
    match *node {
        Node::Quantity(a) | Node::Positive(a) => d(a),
        Node::Negate(a) => negated(of, d(a)),
        Node::Add(a, b) => sum(of, d(a), d(b)),
        Node::Subtract(a, b) => difference(of, d(a), d(b)),
        Node::Multiply(a, b) => {
            let (left, right) = (product(of, d(a), &known(b)), product(of, d(b), &known(a)));
            sum(of, left, right)
        }
        Node::Divide(a, b) => {
            // (a / b)' = (a' - (a / b) b') / b
            let change = product(of, d(b), itself);
            let numerator = difference(of, d(a), change)?;
            Some(of.divide(&numerator, &known(b)))
        }
        Node::Unary(function, a) => {
            let slope = slope(of, function, &known(a), itself);
            product(of, d(a), &slope)
        }
        // not as a weight of zero, which would be lost if the other side has no slope
        Node::Binary(function @ (Function::Min | Function::Max), a, b) => {
            let first = takes_first(of, function, &known(a), &known(b));
            let zero = of.zero();
            let (a, b) = (d(a).unwrap_or_else(|| zero.clone()), d(b).unwrap_or(zero));
            Some(of.select(&first, &a, &b))
        }
        Node::Binary(function, a, b) => {
            let (by_a, by_b) = slopes(of, function, &known(a), &known(b), itself);
            let (left, right) = (product(of, d(a), &by_a), product(of, d(b), &by_b));
            sum(of, left, right)
        }
        Node::Foreign(function, arguments) => {
            let values = arguments.map(&known);
            let mut total = None;
            for (place, argument) in arguments.into_iter().enumerate() {
                if let Some(change) = d(argument) {
                    let slope = of.foreign(function.by(place), &values);
                    let part = Some(of.multiply(&change, &slope));
                    total = sum(of, total, part);
                }
            }
            total
        }
        Node::Select(condition, a, b) => {
            let zero = of.zero();
            let (a, b) = (d(a).unwrap_or_else(|| zero.clone()), d(b).unwrap_or(zero));
            Some(of.select(&known(condition), &a, &b))
        }
        Node::Pivot(a, _) => {
            // (1 / a)' = -(1 / a)^2 a'
            let square = of.square(itself);
            let change = product(of, d(a), &square);
            negated(of, change)
        }
        Node::Number(_)
        | Node::Truth(_)
        | Node::Undefined
        | Node::Symbol(_)
        | Node::Compare(..)
        | Node::And(..)
        | Node::Or(..)
        | Node::Not(_) => None,
    }
}

fn negated<A: Algebra>(of: &mut A, a: Option<A::Value>) -> Option<A::Value> {
    a.map(|a| of.negate(&a))
}

fn sum<A: Algebra>(of: &mut A, a: Option<A::Value>, b: Option<A::Value>) -> Option<A::Value> {
    match (a, b) {
        (Some(a), Some(b)) => Some(of.add(&a, &b)),
        (a, b) => a.or(b),
    }
}

fn difference<A: Algebra>(
    of: &mut A,
    a: Option<A::Value>,
    b: Option<A::Value>,
) -> Option<A::Value> {
    let b = negated(of, b);
    sum(of, a, b)
}

fn product<A: Algebra>(of: &mut A, a: Option<A::Value>, b: &A::Value) -> Option<A::Value> {
    a.map(|a| of.multiply(&a, b))
}
