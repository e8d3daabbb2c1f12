//! Products and quotients: a product is written `early * late`, and nothing is divided by a value
//! known early.

use crate::symbolic::number::Number;

use super::nodes::{Graph, Id, Node};

impl Graph {
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
        self.signed(negative_a ^ negative_b, product)
    }

    fn signed(&mut self, negative: bool, magnitude: Id) -> Id {
        if negative {
            self.negate(magnitude)
        } else {
            magnitude
        }
    }

    fn split_negation(&self, a: Id) -> (bool, Id) {
        match self.node(a) {
            Node::Negate(inner) => (true, *inner),
            _ => (false, a),
        }
    }

    /// The early factor of a product, and the late remainder; either may be one.
    pub fn split_factor(&mut self, a: Id) -> (Id, Id) {
        let one = self.one();
        match *self.node(a) {
            _ if self.is_early(a) => (a, one),
            Node::Multiply(c, x) if self.is_early(c) => (c, x),
            _ => (one, a),
        }
    }

    /// `factor * rest`, where `factor` is early and `rest` is late or one.
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

    /// The product of two early factors in one canonical form: a number times parameters, divided
    /// by parameters.
    fn multiply_known(&mut self, a: Id, b: Id) -> Id {
        if self.is_one(a) && self.is_one(b) {
            return a;
        }
        if let Some(known) = self.products.get(&[a, b]) {
            return *known;
        }
        let product = self.made_product(a, b);
        self.products.insert([a, b], product);
        product
    }

    fn made_product(&mut self, a: Id, b: Id) -> Id {
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

    /// A quotient. A divisor known early is inverted once, and later code multiplies by the
    /// inverse.
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
        self.signed(negative_a ^ negative_b, quotient)
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
}
