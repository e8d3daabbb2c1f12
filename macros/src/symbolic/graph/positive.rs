//! Positive quantities, such as masses and moments of inertia.

use std::collections::HashMap;

use crate::symbolic::number::Function;

use super::nodes::{Graph, Id, Node};

/// The known sign of an expression, wherever it has a value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    Unknown,
    NotNegative,
    Positive,
}

impl Graph {
    /// `a`, or NaN where it is negative. A value known early is checked in the constructor of the
    /// body, and an expression that is nonnegative by its form needs no check: a division by zero
    /// is not finite.
    pub fn positive(&mut self, a: Id) -> Id {
        if self.is_undefined(a) || self.is_early(a) || self.sign(a) != Sign::Unknown {
            return a;
        }
        self.intern(Node::Positive(a))
    }

    /// The same as a separate line, if it changes.
    pub fn positive_quantity(&mut self, a: Id) -> Id {
        if self.is_early(a) {
            return a;
        }
        let positive = self.positive(a);
        self.quantity(positive)
    }

    /// The expression under the check of positivity.
    pub fn unchecked(&self, a: Id) -> Id {
        match *self.node(a) {
            Node::Positive(inner) => inner,
            Node::Quantity(inner) if matches!(self.node(inner), Node::Positive(_)) => {
                self.unchecked(inner)
            }
            _ => a,
        }
    }

    /// Whether it is no less than zero by its form, and may be zero: as a sum of squares.
    pub fn may_touch_zero(&self, a: Id) -> bool {
        self.sign(a) == Sign::NotNegative
    }

    fn sign(&self, a: Id) -> Sign {
        let mut signs: HashMap<Id, Sign> = HashMap::new();
        for id in self.reachable(&[a], |id| !matches!(self.node(id), Node::Positive(_))) {
            let known = |operand: &Id| signs.get(operand).copied().unwrap_or(Sign::Unknown);
            let sign = match self.node(id) {
                Node::Positive(_) | Node::Unary(Function::Exp, _) => Sign::Positive,
                Node::Number(number) if number.is_positive() => Sign::Positive,
                Node::Number(number) if number.is_zero() => Sign::NotNegative,
                Node::Quantity(a) => known(a),
                Node::Add(a, b) => known(a).plus(known(b)),
                Node::Multiply(a, b) if a == b => known(a).squared(),
                Node::Multiply(a, b) | Node::Divide(a, b) => known(a).times(known(b)),
                Node::Unary(Function::Abs | Function::Sqrt, _) => Sign::NotNegative,
                _ => Sign::Unknown,
            };
            signs.insert(id, sign);
        }
        signs.get(&a).copied().unwrap_or(Sign::Unknown)
    }
}

impl Sign {
    fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (Self::NotNegative, Self::NotNegative) => Self::NotNegative,
            _ => Self::Positive,
        }
    }

    fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (Self::Positive, Self::Positive) => Self::Positive,
            _ => Self::NotNegative,
        }
    }

    fn squared(self) -> Self {
        if self == Self::Positive {
            self
        } else {
            Self::NotNegative
        }
    }
}
