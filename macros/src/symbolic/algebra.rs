//! What expressions are computed in: numbers of some kind, or expressions again.
//!
//! What a node is, and how it changes along with its operands, is written once, for all of them.

use super::function::Function;
use super::graph::{Comparison, Id, Node};
use super::number::Number;
use super::slopes::{slope, slopes, takes_first};

/// The operations of nodes.
pub trait Algebra {
    type Value: Clone;

    fn number(&mut self, number: &Number) -> Self::Value;
    fn undefined(&mut self) -> Self::Value;
    fn negate(&mut self, a: &Self::Value) -> Self::Value;
    fn add(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    fn multiply(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    fn divide(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    fn apply(&mut self, function: Function, arguments: &[Self::Value]) -> Self::Value;
    /// Whether a value is zero for certain.
    fn is_zero(&self, a: &Self::Value) -> bool;

    // conditions: of numbers, one is true and zero is false

    fn compare(&mut self, _: Comparison, _: &Self::Value, _: &Self::Value) -> Self::Value {
        self.undefined()
    }

    fn select(&mut self, _: &Self::Value, _: &Self::Value, _: &Self::Value) -> Self::Value {
        self.undefined()
    }

    fn and(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        self.multiply(a, b)
    }

    fn or(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        let (not_a, not_b) = (self.not(a), self.not(b));
        let neither = self.and(&not_a, &not_b);
        self.not(&neither)
    }

    fn not(&mut self, a: &Self::Value) -> Self::Value {
        let one = self.one();
        self.subtract(&one, a)
    }

    fn truth(&mut self, holds: bool) -> Self::Value {
        self.number(&Number::integer(i64::from(holds)))
    }

    // what follows from these

    fn zero(&mut self) -> Self::Value {
        self.number(&Number::zero())
    }

    fn one(&mut self) -> Self::Value {
        self.number(&Number::one())
    }

    fn subtract(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        let negated = self.negate(b);
        self.add(a, &negated)
    }

    fn square(&mut self, a: &Self::Value) -> Self::Value {
        self.multiply(a, a)
    }

    fn quantity(&mut self, a: &Self::Value) -> Self::Value {
        a.clone()
    }

    fn pivot(&mut self, divisor: &Self::Value, _scale: &Self::Value) -> Self::Value {
        let one = self.one();
        self.divide(&one, divisor)
    }
}

/// What a node is that is not a symbol.
pub(super) fn value<A: Algebra>(
    of: &mut A,
    node: &Node,
    known: impl Fn(Id) -> A::Value,
) -> A::Value {
    match *node {
        Node::Number(ref number) => of.number(number),
        Node::Truth(holds) => of.truth(holds),
        Node::Undefined | Node::Symbol(_) => of.undefined(),
        Node::Quantity(a) => of.quantity(&known(a)),
        Node::Negate(a) => of.negate(&known(a)),
        Node::Add(a, b) => of.add(&known(a), &known(b)),
        Node::Subtract(a, b) => of.subtract(&known(a), &known(b)),
        Node::Multiply(a, b) => of.multiply(&known(a), &known(b)),
        Node::Divide(a, b) => of.divide(&known(a), &known(b)),
        Node::Unary(function, a) => of.apply(function, &[known(a)]),
        Node::Binary(function, a, b) => of.apply(function, &[known(a), known(b)]),
        Node::Compare(comparison, a, b) => of.compare(comparison, &known(a), &known(b)),
        Node::And(a, b) => of.and(&known(a), &known(b)),
        Node::Or(a, b) => of.or(&known(a), &known(b)),
        Node::Not(a) => of.not(&known(a)),
        Node::Pivot(a, b) => of.pivot(&known(a), &known(b)),
        Node::Select(condition, a, b) => of.select(&known(condition), &known(a), &known(b)),
    }
}

/// How a node changes along with its operands, one step of the chain rule; `None` is not at all. Steps
/// (`floor`, `ceil`, `signum`) do not change, and a choice changes as its branches do.
pub(super) fn change<A: Algebra>(
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
        Node::Quantity(a) => d(a),
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
        // not as a weight of zero, which would be lost where the other side has no slope
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
