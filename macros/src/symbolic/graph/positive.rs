//! Positive quantities, such as masses and moments of inertia.

use std::collections::HashMap;

use crate::symbolic::number::Function;

use super::nodes::{Graph, Id, Node};

/// The most factors of a product that are compared.
const MOST_FACTORS: usize = 64;

/// The known sign of an expression, wherever it has a value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    Unknown,
    NotNegative,
    Positive,
}

impl Graph {
    /// `a`, or NaN where it is not positive. Two kinds of expressions need no check: those known
    /// early are checked in the constructor of the body, and in those that are nonnegative by their
    /// form, a zero shows when it is divided by, because the quotient is not finite.
    pub fn positive(&mut self, a: Id) -> Id {
        if self.is_undefined(a) || self.is_early(a) || self.sign(a, &[]) != Sign::Unknown {
            return a;
        }
        self.intern(Node::Positive(a))
    }

    /// The same as a statement of its own, unless it is known early.
    pub fn positive_quantity(&mut self, a: Id) -> Id {
        if self.is_early(a) {
            return a;
        }
        let positive = self.positive(a);
        self.quantity(positive)
    }

    /// The expression without its check for positivity.
    pub fn unchecked(&self, a: Id) -> Id {
        match *self.node(a) {
            Node::Positive(inner) => inner,
            Node::Quantity(inner) if matches!(self.node(inner), Node::Positive(_)) => {
                self.unchecked(inner)
            }
            _ => a,
        }
    }

    /// Whether the expression is nonnegative by its form, if these others are positive.
    pub fn is_never_negative(&self, a: Id, positive: &[Id]) -> bool {
        self.sign(a, positive) != Sign::Unknown
    }

    /// Whether the expression is nonnegative by its form but may be zero, as a sum of squares is.
    pub fn may_touch_zero(&self, a: Id) -> bool {
        self.sign(a, &[]) == Sign::NotNegative
    }

    fn sign(&self, a: Id, positive: &[Id]) -> Sign {
        let mut signs: HashMap<Id, Sign> = HashMap::new();
        for id in self.reachable(&[a], &|id| !matches!(self.node(id), Node::Positive(_))) {
            let known = |operand: Id| signs.get(&operand).copied().unwrap_or(Sign::Unknown);
            let sign = match self.node(id) {
                _ if positive.contains(&id) => Sign::Positive,
                Node::Positive(_) | Node::Unary(Function::Exp, _) => Sign::Positive,
                Node::Number(number) if number.is_positive() && !number.is_undecided() => {
                    Sign::Positive
                }
                Node::Number(number) if number.is_zero() => Sign::NotNegative,
                Node::Quantity(a) => known(*a),
                Node::Add(a, b) => known(*a).plus(known(*b)),
                Node::Multiply(a, b) if a == b => known(*a).squared(),
                // for a divisor, only its written form counts: a zero must appear in the quotient
                Node::Multiply(a, b) if positive.is_empty() => known(*a).times(known(*b)),
                Node::Multiply(..) => self.sign_of_product(id, known),
                Node::Divide(a, b) => known(*a).times(known(*b)),
                Node::Unary(Function::Abs | Function::Sqrt, _) => Sign::NotNegative,
                _ => Sign::Unknown,
            };
            signs.insert(id, sign);
        }
        signs.get(&a).copied().unwrap_or(Sign::Unknown)
    }

    /// The sign of a product, whose factors may occur several times.
    fn sign_of_product(&self, id: Id, known: impl Fn(Id) -> Sign) -> Sign {
        let (mut factors, mut open) = (Vec::new(), vec![id]);
        while let Some(next) = open.pop() {
            match *self.node(next) {
                Node::Multiply(a, b) if factors.len() + open.len() < MOST_FACTORS => {
                    open.extend([a, b]);
                }
                _ => factors.push(next),
            }
        }
        factors.sort_unstable();
        let alike = factors.chunk_by(|a, b| a == b);
        let signs = alike.map(|alike| match alike.len() % 2 {
            0 => known(alike[0]).squared(),
            _ => known(alike[0]),
        });
        signs.fold(Sign::Positive, Sign::times)
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
