//! Algebras: the operations of nodes on values of some kind, such as numbers or expressions.
//!
//! The value of a node, and its change with its operands, are written once, for all algebras.

use crate::symbolic::graph::{Comparison, Id, Node};
use crate::symbolic::number::{Foreign, Function, Number};

use super::multiples::Multiples;

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
    /// A foreign function, one that is defined outside the description.
    fn foreign(
        &mut self,
        function: Foreign,
        arguments: &[Self::Value; Foreign::ARGUMENTS],
    ) -> Self::Value;
    /// Whether a value is certainly zero.
    fn is_zero(&self, a: &Self::Value) -> bool;

    /// Learns the sum that the argument of a function is, if the function turns sums into products.
    fn know_sum(
        &mut self,
        _argument: &Self::Value,
        _sum: impl FnOnce() -> Option<Multiples<Self::Value>>,
    ) {
    }

    // conditions: in numbers, one is true and zero is false

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

    // derived operations

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

    /// A value if it is positive, and no value otherwise; algebras that cannot tell return it
    /// unchanged.
    fn positive(&mut self, a: &Self::Value) -> Self::Value {
        a.clone()
    }

    fn pivot(&mut self, divisor: &Self::Value, _scale: &Self::Value) -> Self::Value {
        let one = self.one();
        self.divide(&one, divisor)
    }
}

/// The value of a node that is not a symbol.
pub fn value<A: Algebra>(of: &mut A, node: &Node, known: impl Fn(Id) -> A::Value) -> A::Value {
    match *node {
        Node::Number(ref number) => of.number(number),
        Node::Truth(holds) => of.truth(holds),
        Node::Undefined | Node::Symbol(_) => of.undefined(),
        Node::Quantity(a) => of.quantity(&known(a)),
        Node::Positive(a) => of.positive(&known(a)),
        Node::Negate(a) => of.negate(&known(a)),
        Node::Add(a, b) => of.add(&known(a), &known(b)),
        Node::Subtract(a, b) => of.subtract(&known(a), &known(b)),
        Node::Multiply(a, b) => of.multiply(&known(a), &known(b)),
        Node::Divide(a, b) => of.divide(&known(a), &known(b)),
        Node::Unary(function, a) => of.apply(function, &[known(a)]),
        Node::Binary(function, a, b) => of.apply(function, &[known(a), known(b)]),
        Node::Foreign(function, arguments) => of.foreign(function, &arguments.map(known)),
        Node::Compare(comparison, a, b) => of.compare(comparison, &known(a), &known(b)),
        Node::And(a, b) => of.and(&known(a), &known(b)),
        Node::Or(a, b) => of.or(&known(a), &known(b)),
        Node::Not(a) => of.not(&known(a)),
        Node::Pivot(a, b) => of.pivot(&known(a), &known(b)),
        Node::Select(condition, a, b) => of.select(&known(condition), &known(a), &known(b)),
    }
}
