//! Simplifying constructors: the only way to make a node.
//!
//! Factors known early are gathered: a product is written `early * late`, so numbers fold and
//! parameters are multiplied once, in the constructor of the body. Signs move outwards until a sum
//! absorbs them. Beyond that, no sum is multiplied out and no order of summation is changed: the
//! form of the equations is the responsibility of their author.
//!
//! The rules are those of real numbers. They hold wherever an expression has a value: `0 * x`,
//! `x - x` and `0 / x` are zero, `x / x` and `x * (1 / x)` are one. Where it has none, because `x`
//! is zero or NaN, the simplified expression may have one.

use crate::symbolic::number::{Foreign, Function, Number, ORDERS, Table};

use super::nodes::{Comparison, Graph, Id, Node, ONE, Stage, ZERO};

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

    #[expect(clippy::unused_self, reason = "called as the other constructors are")]
    pub fn zero(&self) -> Id {
        ZERO
    }

    #[expect(clippy::unused_self, reason = "called as the other constructors are")]
    pub fn one(&self) -> Id {
        ONE
    }

    pub fn truth(&mut self, value: bool) -> Id {
        self.intern(Node::Truth(value))
    }

    /// An expression without a value.
    pub fn undefined(&mut self) -> Id {
        self.intern(Node::Undefined)
    }

    /// Makes `a` a statement: expressions built from it use its name. Symbols and
    /// constants are unchanged, and a sign stays outside.
    pub fn quantity(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Undefined | Node::Symbol(_) | Node::Quantity(_) => a,
            _ if self.stage(a) == Stage::Constant => a,
            Node::Negate(inner) => {
                let inner = self.quantity(inner);
                self.negate(inner)
            }
            _ => self.intern(Node::Quantity(a)),
        }
    }

    /// The content of a quantity, as part of an expression built from it.
    pub fn unnamed(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Quantity(inner) => inner,
            Node::Negate(inner) => {
                let inner = self.unnamed(inner);
                self.negate(inner)
            }
            _ => a,
        }
    }

    pub fn negate(&mut self, a: Id) -> Id {
        if let Some(known) = self.negatives[a.index()] {
            return known;
        }
        let negative = self.made_negative(a);
        self.negatives[a.index()] = Some(negative);
        negative
    }

    fn made_negative(&mut self, a: Id) -> Id {
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

    /// Makes `a`, including its sign, a statement: a result from which nothing is built.
    pub fn result(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Negate(_) if self.stage(a) != Stage::Constant => self.intern(Node::Quantity(a)),
            _ => self.quantity(a),
        }
    }

    /// `1 / divisor`. It is guarded: a divisor no larger than the rounding error of terms of the
    /// size `scale` is not used. A divisor known early is checked where it is computed.
    pub fn pivot(&mut self, divisor: Id, scale: Id) -> Id {
        if self.is_early(divisor) {
            let one = self.one();
            return self.divide(one, divisor);
        }
        self.checked_reciprocal(divisor, scale)
    }

    /// The same, but a divisor known early is guarded too; a guard that fails gives NaN there.
    pub fn checked_reciprocal(&mut self, divisor: Id, scale: Id) -> Id {
        if self.as_number(divisor).is_some() {
            let one = self.one();
            return self.divide(one, divisor);
        }
        self.intern(Node::Pivot(divisor, scale))
    }

    /// `1 / divisor` of a [positive](Self::positive) divisor.
    pub fn inverse_of_positive(&mut self, divisor: Id) -> Id {
        let (one, divisor) = (self.one(), self.positive(divisor));
        self.divide(one, divisor)
    }

    /// The negative of `a`, if it already exists.
    pub fn negation_of(&self, a: Id) -> Option<Id> {
        let negated = self.find(&Node::Negate(a));
        negated.or_else(|| {
            let Node::Multiply(factor, b) = *self.node(a) else {
                return None;
            };
            let opposite = -self.as_number(factor)?.clone();
            let opposite = self.find(&Node::Number(opposite))?;
            self.find(&Node::Multiply(opposite, b))
        })
    }

    /// The statement that `a` is, if there is one.
    pub fn quantity_of(&self, a: Id) -> Option<Id> {
        self.find(&Node::Quantity(a))
    }

    /// The statement that `a` is, except for its sign, or `a` if there is none.
    pub fn known_quantity(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Negate(inner) => match self.quantity_of(inner) {
                Some(known) => self.negate(known),
                None => a,
            },
            _ => self.quantity_of(a).unwrap_or(a),
        }
    }

    /// Whether `a` is written with a leading minus, and what follows the sign.
    pub fn split_sign(&mut self, a: Id) -> (bool, Id) {
        let negative = match self.node(a) {
            Node::Negate(_) => true,
            Node::Number(number) => number.is_negative(),
            Node::Multiply(factor, _) => self.as_number(*factor).is_some_and(Number::is_negative),
            _ => false,
        };
        (negative, if negative { self.negate(a) } else { a })
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

    /// A new table.
    pub fn new_table(&mut self, table: Table) -> Id {
        self.tables.push(table);
        let number = i64::try_from(self.tables.len() - 1).unwrap_or(0);
        self.integer(number * ORDERS)
    }

    /// The table with this index, or its derivative.
    pub fn table(&self, number: Id) -> Option<Table> {
        let number = self.as_number(number)?.to_integer()?;
        let [number, order] = [number / ORDERS, number % ORDERS].map(usize::try_from);
        Some(self.tables.get(number.ok()?)?.derivative(order.ok()?))
    }

    /// The value of a table.
    fn tabulated(&mut self, argument: Id, table: Id) -> Id {
        let known = self.as_number(argument).cloned().zip(self.table(table));
        match known {
            Some((argument, table)) => self.number(table.value(&argument)),
            None => self.intern(Node::Binary(Function::Table, argument, table)),
        }
    }

    /// A function of one or two arguments.
    pub fn apply(&mut self, function: Function, arguments: &[Id]) -> Id {
        if arguments
            .iter()
            .any(|argument| self.is_undefined(*argument))
        {
            return self.undefined();
        }
        if let (Function::Table, &[argument, table]) = (function, arguments) {
            return self.tabulated(argument, table);
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

    /// A foreign function.
    pub fn foreign(&mut self, function: Foreign, arguments: [Id; Foreign::ARGUMENTS]) -> Id {
        if arguments
            .iter()
            .any(|argument| self.is_undefined(*argument))
        {
            return self.undefined();
        }
        self.intern(Node::Foreign(function, arguments))
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

    /// Constants that thousands of bits cannot tell apart are compared as doubles, which are equal.
    pub fn compare(&mut self, comparison: Comparison, a: Id, b: Id) -> Id {
        let known = match (self.as_number(a), self.as_number(b)) {
            (Some(x), Some(y)) if (x.clone() - y.clone()).is_undecided() => {
                Some(core::cmp::Ordering::Equal)
            }
            (Some(x), Some(y)) => Some(x.cmp(y)),
            _ if a == b => Some(core::cmp::Ordering::Equal),
            _ => None,
        };
        match known {
            Some(order) => self.truth(comparison.holds(order)),
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
