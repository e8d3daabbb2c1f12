//! The chain rule: the change of a node with its operands, for all algebras.

use crate::symbolic::graph::{Id, Node};
use crate::symbolic::number::Function;

use super::operations::Algebra;
use super::slopes::{slope, slopes, takes_first};

/// The change of a node with its operands, one step of the chain rule, computed from their values
/// and their changes `d`. `None` means that nothing changes. Step functions (`floor`, `ceil`,
/// `signum`) do not change, and a choice changes as its branches do.
pub fn change<A: Algebra>(
    of: &mut A,
    node: &Node,
    itself: &A::Value,
    known: impl Fn(Id) -> A::Value,
    d: impl Fn(Id) -> Option<A::Value>,
) -> Option<A::Value> {
    if node.operands().all(|operand| d(operand).is_none()) {
        return None;
    }
    match *node {
        Node::Quantity(a) | Node::Positive(a) => d(a),
        Node::Negate(a) => negated(of, d(a)),
        Node::Add(a, b) => sum(of, d(a), d(b)),
        Node::Subtract(a, b) => difference(of, d(a), d(b)),
        Node::Multiply(a, b) => combined(of, (d(a), &known(b)), (d(b), &known(a))),
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
        // a choice, not a weight of zero: that would be lost if the other side has no slope
        Node::Binary(function @ (Function::Min | Function::Max), a, b) => {
            let first = takes_first(of, function, &known(a), &known(b));
            Some(chosen(of, &first, d(a), d(b)))
        }
        Node::Binary(function, a, b) => {
            let (by_a, by_b) = slopes(of, function, &known(a), &known(b), itself);
            combined(of, (d(a), &by_a), (d(b), &by_b))
        }
        Node::Foreign(function, arguments) => {
            let values = arguments.map(&known);
            let changes = arguments.into_iter().map(&d).enumerate();
            changes.fold(None, |total, (place, change)| {
                let part = change.map(|change| {
                    let slope = of.foreign(function.by(place), &values);
                    of.multiply(&change, &slope)
                });
                sum(of, total, part)
            })
        }
        Node::Select(condition, a, b) => Some(chosen(of, &known(condition), d(a), d(b))),
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

/// The change of the chosen branch.
fn chosen<A: Algebra>(
    of: &mut A,
    is_first: &A::Value,
    a: Option<A::Value>,
    b: Option<A::Value>,
) -> A::Value {
    let zero = of.zero();
    let (a, b) = (a.unwrap_or_else(|| zero.clone()), b.unwrap_or(zero));
    of.select(is_first, &a, &b)
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

/// The sum of two changes, each multiplied by its slope.
fn combined<A: Algebra>(
    of: &mut A,
    (a, by_a): (Option<A::Value>, &A::Value),
    (b, by_b): (Option<A::Value>, &A::Value),
) -> Option<A::Value> {
    let (a, b) = (product(of, a, by_a), product(of, b, by_b));
    sum(of, a, b)
}

fn product<A: Algebra>(of: &mut A, a: Option<A::Value>, b: &A::Value) -> Option<A::Value> {
    a.map(|a| of.multiply(&a, b))
}
