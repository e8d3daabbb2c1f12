//! Sums: like terms are collected, common early factors are taken out, early terms are
//! gathered, and signs become subtractions.

use crate::symbolic::number::Number;

use super::nodes::{Graph, Id, Node};

impl Graph {
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        if self.is_undefined(a) || self.is_zero(b) {
            return a;
        }
        if self.is_undefined(b) || self.is_zero(a) {
            return b;
        }
        if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(b)) {
            let sum = x.clone() + y.clone();
            return self.number(sum);
        }
        if let Some(collected) = self.add_like(a, b) {
            return collected;
        }
        if let Some(factored) = self.add_factored(a, b) {
            return factored;
        }
        let ((early_a, late_a), (early_b, late_b)) = (self.split_term(a), self.split_term(b));
        if self.is_zero(early_a) || self.is_zero(early_b) {
            return self.add_signed(a, b);
        }
        let early = self.add_known(early_a, early_b);
        let late = self.add(late_a, late_b);
        if self.is_zero(early) || self.is_zero(late) {
            self.add(early, late)
        } else {
            self.add_signed(early, late)
        }
    }

    /// `c x + d x = (c + d) x` for early `c` and `d`.
    fn add_like(&mut self, a: Id, b: Id) -> Option<Id> {
        let ((_, magnitude_a), (_, magnitude_b)) = (self.split_sign(a), self.split_sign(b));
        let ((_, x), (_, y)) = (
            self.split_coefficient(magnitude_a),
            self.split_coefficient(magnitude_b),
        );
        // one of them may be a statement, and the other what it contains
        let alike = [(x, y), (y, x)];
        let same = if x == y {
            Some(x)
        } else {
            let mut alike = alike.into_iter();
            alike.find_map(|(inner, other)| self.quantity_of(inner).filter(|id| *id == other))
        };
        let same = same.filter(|id| !self.is_one(*id))?;
        let (c, d) = (self.signed_factor(a), self.signed_factor(b));
        let sum = self.add(c, d);
        Some(self.multiply(sum, same))
    }

    /// `c x + c y = c (x + y)` for an early `c`.
    fn add_factored(&mut self, a: Id, b: Id) -> Option<Id> {
        if self.is_early(a) || self.is_early(b) {
            return None;
        }
        let ((negative_a, a), (negative_b, b)) = (self.split_sign(a), self.split_sign(b));
        let ((c, x), (d, y)) = (self.split_factor(a), self.split_factor(b));
        if c != d || self.is_one(c) {
            return None;
        }
        let x = if negative_a { self.negate(x) } else { x };
        let y = if negative_b { self.negate(y) } else { y };
        let sum = self.add(x, y);
        Some(self.multiply(c, sum))
    }

    fn signed_factor(&mut self, a: Id) -> Id {
        let (negative, magnitude) = self.split_sign(a);
        let (factor, _) = self.split_coefficient(magnitude);
        if negative {
            self.negate(factor)
        } else {
            factor
        }
    }

    /// The sum of two early terms: numbers are gathered, everything else stays as it is.
    fn add_known(&mut self, a: Id, b: Id) -> Id {
        let ((number_a, rest_a), (number_b, rest_b)) = (self.split_number(a), self.split_number(b));
        let number = number_a + number_b;
        let number = self.number(number);
        if self.is_zero(rest_a) || self.is_zero(rest_b) {
            let rest = if self.is_zero(rest_a) { rest_b } else { rest_a };
            return self.add_apart(rest, number);
        }
        let rest = match self.add_like(rest_a, rest_b) {
            Some(rest) => rest,
            None => self.add_signed(rest_a, rest_b),
        };
        self.add_apart(rest, number)
    }

    fn add_apart(&mut self, rest: Id, number: Id) -> Id {
        if self.is_zero(number) {
            rest
        } else if self.is_zero(rest) {
            number
        } else {
            self.add_signed(rest, number)
        }
    }

    /// The number in an early sum, and the remainder.
    fn split_number(&mut self, a: Id) -> (Number, Id) {
        let zero = self.zero();
        match *self.node(a) {
            Node::Number(ref number) => (number.clone(), zero),
            Node::Add(x, y) => match (self.as_number(x), self.as_number(y)) {
                (Some(number), _) => (number.clone(), y),
                (_, Some(number)) => (number.clone(), x),
                _ => (Number::zero(), a),
            },
            Node::Subtract(x, y) => {
                match (self.as_number(x).cloned(), self.as_number(y).cloned()) {
                    (Some(number), _) => (number, self.negate(y)),
                    (_, Some(number)) => (-number, x),
                    _ => (Number::zero(), a),
                }
            }
            _ => (Number::zero(), a),
        }
    }

    /// The early term of a sum, and the remainder; either may be zero.
    pub(in crate::symbolic) fn split_term(&mut self, a: Id) -> (Id, Id) {
        let zero = self.zero();
        if self.is_early(a) {
            return (a, zero);
        }
        match *self.node(a) {
            Node::Add(x, y) if self.is_early(x) => (x, y),
            Node::Add(x, y) if self.is_early(y) => (y, x),
            Node::Subtract(x, y) if self.is_early(x) => (x, self.negate(y)),
            Node::Subtract(x, y) if self.is_early(y) => (self.negate(y), x),
            Node::Negate(sum) => {
                let (early, late) = self.split_term(sum);
                (self.negate(early), self.negate(late))
            }
            _ => (zero, a),
        }
    }

    /// A sum of unrelated terms; signs become subtractions.
    fn add_signed(&mut self, a: Id, b: Id) -> Id {
        let ((negative_a, x), (negative_b, y)) = (self.split_sign(a), self.split_sign(b));
        match (negative_a, negative_b) {
            (false, false) => self.intern(Node::Add(x.min(y), x.max(y))),
            (false, true) => self.subtract_apart(x, y),
            (true, false) => self.subtract_apart(y, x),
            (true, true) => {
                let sum = self.intern(Node::Add(x.min(y), x.max(y)));
                self.negate(sum)
            }
        }
    }

    /// `x - y`; if `y - x` exists already, the negative of that.
    fn subtract_apart(&mut self, x: Id, y: Id) -> Id {
        match self.find(&Node::Subtract(y, x)) {
            Some(opposite) => self.intern(Node::Negate(opposite)),
            None => self.intern(Node::Subtract(x, y)),
        }
    }

    pub fn subtract(&mut self, a: Id, b: Id) -> Id {
        let negated = self.negate(b);
        self.add(a, negated)
    }

    /// The sum of many terms. Late terms are added first; the early ones then gather into one.
    pub fn sum(&mut self, terms: &[Id]) -> Id {
        let mut sum = self.zero();
        let (early, late): (Vec<Id>, Vec<Id>) =
            terms.iter().partition(|term| self.is_early(**term));
        for term in late.into_iter().chain(early) {
            sum = self.add(sum, term);
        }
        sum
    }

    /// `(c, x)` of a term `c x`, to be combined with terms `d x`. If x is a parameter, `c` is a
    /// number.
    fn split_coefficient(&mut self, a: Id) -> (Id, Id) {
        let one = self.one();
        match *self.node(a) {
            Node::Multiply(c, x)
                if self.is_early(c) && (!self.is_early(x) || self.as_number(c).is_some()) =>
            {
                (c, x)
            }
            Node::Number(_) => (a, one),
            _ => (one, a),
        }
    }
}
