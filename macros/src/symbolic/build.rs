//! Simplifying constructors: the only way to make a node.
//!
//! What is known early is gathered: a product is written `early * late`, so that numbers fold and
//! parameters are multiplied once, in the constructor of the body. Signs move outwards until a sum
//! absorbs them. `0 * x` is `0` for every `x`, as it is in the mechanics: a term that is
//! identically zero does not exist. No sum is multiplied out and no order of summation is changed
//! beyond that: the form of the equations is the business of those who write them.

use super::graph::{Comparison, Graph, Id, Node};
use super::number::{Function, Number};

impl Graph {
    pub fn number(&mut self, number: Number) -> Id {
        if number.is_carried() {
            self.intern(Node::Number(number))
        } else {
            self.undefined()
        }
    }

    pub fn integer(&mut self, value: i64) -> Id {
        self.number(Number::integer(value))
    }

    pub fn zero(&mut self) -> Id {
        self.integer(0)
    }

    pub fn one(&mut self) -> Id {
        self.integer(1)
    }

    pub fn truth(&mut self, value: bool) -> Id {
        self.intern(Node::Truth(value))
    }

    fn undefined(&mut self) -> Id {
        self.intern(Node::Undefined)
    }

    /// Makes `a` a statement of its own: what is built from it is built from its name. Symbols and
    /// what is known early stay as they are, and a sign stays outside.
    pub fn quantity(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Undefined | Node::Symbol(_) | Node::Quantity(_) => a,
            _ if self.is_early(a) => a,
            Node::Negate(inner) => {
                let inner = self.quantity(inner);
                self.negate(inner)
            }
            _ => self.intern(Node::Quantity(a)),
        }
    }

    pub fn negate(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Undefined => a,
            Node::Number(ref number) => {
                let negated = -number.clone();
                self.number(negated)
            }
            Node::Negate(inner) => inner,
            Node::Multiply(factor, rest) if self.as_number(factor).is_some() => {
                let negated = self.negate(factor);
                self.multiply(negated, rest)
            }
            _ => self.intern(Node::Negate(a)),
        }
    }

    /// The negative of `a`, if anybody made it.
    pub fn negation_of(&self, a: Id) -> Option<Id> {
        self.find(&Node::Negate(a))
    }

    /// Whether `a` is written with a leading minus, and what follows it.
    pub fn split_sign(&mut self, a: Id) -> (bool, Id) {
        let negative = match self.node(a) {
            Node::Negate(_) => true,
            Node::Number(number) => number.is_negative(),
            Node::Multiply(factor, _) => self.as_number(*factor).is_some_and(Number::is_negative),
            _ => false,
        };
        (negative, if negative { self.negate(a) } else { a })
    }

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
        if x != y || self.is_one(x) {
            return None;
        }
        let (c, d) = (self.signed_factor(a), self.signed_factor(b));
        let sum = self.add(c, d);
        Some(self.multiply(sum, x))
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

    /// Sum of two early terms: numbers are gathered, the rest is kept as it is.
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

    /// The number in an early sum, and the rest.
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

    /// The early term of a sum, and the rest; either may be zero.
    pub(super) fn split_term(&mut self, a: Id) -> (Id, Id) {
        let zero = self.zero();
        if self.is_early(a) {
            return (a, zero);
        }
        match *self.node(a) {
            Node::Add(x, y) if self.is_early(x) => (x, y),
            Node::Add(x, y) if self.is_early(y) => (y, x),
            Node::Subtract(x, y) if self.is_early(x) => (x, self.negate(y)),
            Node::Subtract(x, y) if self.is_early(y) => (self.negate(y), x),
            _ => (zero, a),
        }
    }

    /// A sum of which the terms have nothing to do with each other; signs become subtractions.
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

    /// `x - y`; where `y - x` exists already, its negative.
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

    /// Sum of many terms: what is known early is added first.
    pub fn sum(&mut self, terms: &[Id]) -> Id {
        let mut sum = self.zero();
        let (early, late): (Vec<Id>, Vec<Id>) =
            terms.iter().partition(|term| self.is_early(**term));
        for term in late.into_iter().chain(early) {
            sum = self.add(sum, term);
        }
        sum
    }

    pub fn multiply(&mut self, a: Id, b: Id) -> Id {
        if self.is_undefined(a) || self.is_one(b) || self.is_zero(a) && !self.is_undefined(b) {
            return a;
        }
        if self.is_undefined(b) || self.is_one(a) || self.is_zero(b) {
            return b;
        }
        if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(b)) {
            let product = x.clone() * y.clone();
            return self.number(product);
        }
        let ((negative_a, a), (negative_b, b)) = (self.split_negation(a), self.split_negation(b));
        let ((c, x), (d, y)) = (self.split_factor(a), self.split_factor(b));
        let early = self.multiply_known(c, d);
        let late = self.multiply_late(x, y);
        let product = self.scale(early, late);
        if negative_a != negative_b {
            self.negate(product)
        } else {
            product
        }
    }

    fn split_negation(&self, a: Id) -> (bool, Id) {
        match self.node(a) {
            Node::Negate(inner) => (true, *inner),
            _ => (false, a),
        }
    }

    /// The early factor of a product, and the late rest; either may be one.
    pub fn split_factor(&mut self, a: Id) -> (Id, Id) {
        let one = self.one();
        match *self.node(a) {
            _ if self.is_early(a) => (a, one),
            Node::Multiply(c, x) if self.is_early(c) => (c, x),
            _ => (one, a),
        }
    }

    /// `(c, x)` of a term `c x` that is added to terms `d x`: in front of parameters, `c` is a number.
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

    /// `factor * rest` of an early factor and a late rest, or one.
    fn scale(&mut self, factor: Id, rest: Id) -> Id {
        if self.is_one(rest) {
            return factor;
        }
        if self.is_one(factor) {
            return rest;
        }
        let (negative, factor) = self.split_negation(factor);
        let product = match self.as_number(factor).and_then(Number::to_integer) {
            Some(-1) => self.intern(Node::Negate(rest)),
            _ => self.intern(Node::Multiply(factor, rest)),
        };
        if negative {
            self.negate(product)
        } else {
            product
        }
    }

    fn multiply_late(&mut self, x: Id, y: Id) -> Id {
        if self.is_one(x) {
            return y;
        }
        if self.is_one(y) {
            return x;
        }
        for (x, y) in [(x, y), (y, x)] {
            if let Node::Divide(numerator, denominator) = *self.node(y)
                && (denominator == x || self.is_one(numerator))
            {
                return if denominator == x {
                    numerator
                } else {
                    self.divide(x, denominator)
                };
            }
        }
        self.intern(Node::Multiply(x.min(y), x.max(y)))
    }

    /// Product of two early factors, in one canonical form: a number, parameters, over parameters.
    fn multiply_known(&mut self, a: Id, b: Id) -> Id {
        let mut number = Number::one();
        let mut powers: Vec<(Id, i32)> = Vec::new();
        let mut pending = vec![(a, 1), (b, 1)];
        while let Some((factor, power)) = pending.pop() {
            match *self.node(factor) {
                Node::Undefined => return factor,
                Node::Number(ref value) if power > 0 => number = number * value.clone(),
                Node::Number(ref value) => match number.checked_div(value) {
                    Some(quotient) => number = quotient,
                    None => return self.undefined(),
                },
                Node::Negate(inner) => {
                    number = -number;
                    pending.push((inner, power));
                }
                Node::Multiply(x, y) => pending.extend([(x, power), (y, power)]),
                Node::Divide(x, y) => pending.extend([(x, power), (y, -power)]),
                _ => powers.push((factor, power)),
            }
        }
        if number.is_zero() {
            return self.zero();
        }
        powers.sort_unstable();
        let (mut above, mut below) = (self.one(), self.one());
        for group in powers.chunk_by(|x, y| x.0 == y.0) {
            let power: i32 = group.iter().map(|(_, power)| power).sum();
            for _ in 0..power.unsigned_abs() {
                let side = if power > 0 { &mut above } else { &mut below };
                let known = *side;
                *side = if self.is_one(known) {
                    group[0].0
                } else {
                    self.intern(Node::Multiply(known, group[0].0))
                };
            }
        }
        self.known_quotient(number, above, below)
    }

    /// `number * above / below`, with the number in the numerator.
    fn known_quotient(&mut self, number: Number, above: Id, below: Id) -> Id {
        let negative = number.is_negative()
            && (!self.is_one(above) || !self.is_one(below))
            && (-number.clone()).is_one();
        let scale = if negative { -number } else { number };
        let scale = self.number(scale);
        let numerator = match (self.is_one(scale), self.is_one(above)) {
            (_, true) => scale,
            (true, false) => above,
            (false, false) => self.intern(Node::Multiply(scale, above)),
        };
        let quotient = if self.is_one(below) {
            numerator
        } else {
            self.intern(Node::Divide(numerator, below))
        };
        if negative {
            self.negate(quotient)
        } else {
            quotient
        }
    }

    /// A quotient. What is known early is divided once; there is no division by it later.
    pub fn divide(&mut self, a: Id, b: Id) -> Id {
        if self.is_undefined(a) || self.is_one(b) {
            return a;
        }
        if self.is_undefined(b) || self.is_zero(b) {
            return self.undefined();
        }
        if self.is_zero(a) {
            return a;
        }
        let one = self.one();
        if a == b {
            return one;
        }
        if self.is_early(b) {
            let reciprocal = match self
                .as_number(b)
                .and_then(|number| Number::one().checked_div(number))
            {
                Some(number) => self.number(number),
                None => self.known_reciprocal(b),
            };
            return self.multiply(a, reciprocal);
        }
        let ((negative_a, a), (negative_b, b)) = (self.split_negation(a), self.split_negation(b));
        let ((c, x), (d, y)) = (self.split_factor(a), self.split_factor(b));
        let early = self.divide(c, d);
        let quotient = if x == y {
            early
        } else if self.is_one(x) {
            self.intern(Node::Divide(early, y))
        } else {
            let late = self.intern(Node::Divide(x, y));
            self.scale(early, late)
        };
        if negative_a != negative_b {
            self.negate(quotient)
        } else {
            quotient
        }
    }

    fn known_reciprocal(&mut self, b: Id) -> Id {
        let one = self.one();
        let (negative, b) = self.split_sign(b);
        let reciprocal = match *self.node(b) {
            Node::Multiply(x, y) => {
                let (x, y) = (self.divide(one, x), self.divide(one, y));
                self.multiply_known(x, y)
            }
            Node::Divide(x, y) => self.divide(y, x),
            _ => self.intern(Node::Divide(one, b)),
        };
        if negative {
            self.negate(reciprocal)
        } else {
            reciprocal
        }
    }

    pub fn square(&mut self, a: Id) -> Id {
        self.multiply(a, a)
    }

    /// An integer power by repeated squaring; `0` to a negative power is undefined.
    pub fn powi(&mut self, base: Id, exponent: i32) -> Id {
        let mut result = self.one();
        let mut power = base;
        let mut remaining = exponent.unsigned_abs();
        while remaining > 0 {
            if remaining & 1 == 1 {
                result = self.multiply(result, power);
            }
            remaining >>= 1;
            if remaining > 0 {
                power = self.square(power);
            }
        }
        let one = self.one();
        if exponent < 0 {
            self.divide(one, result)
        } else {
            result
        }
    }

    /// A function of one argument, or of two.
    pub fn apply(&mut self, function: Function, arguments: &[Id]) -> Id {
        if arguments
            .iter()
            .any(|argument| self.is_undefined(*argument))
        {
            return self.undefined();
        }
        let numbers: Vec<Number> = arguments
            .iter()
            .filter_map(|id| self.as_number(*id).cloned())
            .collect();
        if numbers.len() == arguments.len() {
            return match Number::apply(function, &numbers) {
                Some(value) => self.number(value),
                None => self.undefined(),
            };
        }
        match (function, arguments) {
            (Function::Powf, &[base, exponent]) => self.powf(base, exponent),
            (Function::Min | Function::Max, &[a, b]) if a == b => a,
            (Function::Min | Function::Max | Function::Hypot, &[a, b]) => {
                self.intern(Node::Binary(function, a.min(b), a.max(b)))
            }
            (_, &[a, b]) => self.intern(Node::Binary(function, a, b)),
            (_, &[a]) => self.apply_unary(function, a),
            _ => self.undefined(),
        }
    }

    fn apply_unary(&mut self, function: Function, a: Id) -> Id {
        let (negative, magnitude) = self.split_sign(a);
        let (even, odd) = match function {
            Function::Cos | Function::Cosh | Function::Abs => (true, false),
            Function::Sin
            | Function::Tan
            | Function::Sinh
            | Function::Tanh
            | Function::Asin
            | Function::Atan => (false, true),
            _ => (false, false),
        };
        if negative && (even || odd) {
            let value = self.intern(Node::Unary(function, magnitude));
            return if odd { self.negate(value) } else { value };
        }
        self.intern(Node::Unary(function, a))
    }

    fn powf(&mut self, base: Id, exponent: Id) -> Id {
        match self
            .as_number(exponent)
            .and_then(Number::to_integer)
            .map(i32::try_from)
        {
            Some(Ok(exponent)) if exponent.abs() <= 64 => self.powi(base, exponent),
            _ => self.intern(Node::Binary(Function::Powf, base, exponent)),
        }
    }

    pub fn compare(&mut self, comparison: Comparison, a: Id, b: Id) -> Id {
        let known = match (self.as_number(a), self.as_number(b)) {
            (Some(x), Some(y)) => Some(x.cmp(y)),
            _ if a == b => Some(core::cmp::Ordering::Equal),
            _ => None,
        };
        match known {
            Some(order) => {
                let holds = match comparison {
                    Comparison::Less => order.is_lt(),
                    Comparison::LessOrEqual => order.is_le(),
                    Comparison::Equal => order.is_eq(),
                    Comparison::NotEqual => order.is_ne(),
                };
                self.truth(holds)
            }
            None => self.intern(Node::Compare(comparison, a, b)),
        }
    }

    pub fn and(&mut self, a: Id, b: Id) -> Id {
        match (self.node(a), self.node(b)) {
            (Node::Truth(true), _) | (_, Node::Truth(false)) => b,
            (_, Node::Truth(true)) | (Node::Truth(false), _) => a,
            _ => self.intern(Node::And(a, b)),
        }
    }

    pub fn or(&mut self, a: Id, b: Id) -> Id {
        match (self.node(a), self.node(b)) {
            (Node::Truth(false), _) | (_, Node::Truth(true)) => b,
            (_, Node::Truth(false)) | (Node::Truth(true), _) => a,
            _ => self.intern(Node::Or(a, b)),
        }
    }

    pub fn not(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Truth(value) => self.truth(!value),
            Node::Not(inner) => inner,
            _ => self.intern(Node::Not(a)),
        }
    }

    pub fn select(&mut self, condition: Id, first: Id, second: Id) -> Id {
        match *self.node(condition) {
            _ if first == second => first,
            Node::Truth(true) => first,
            Node::Truth(false) => second,
            Node::Not(inner) => self.select(inner, second, first),
            _ => self.intern(Node::Select(condition, first, second)),
        }
    }
}
