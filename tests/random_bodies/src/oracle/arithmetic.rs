//! Scalars computed from scalars, wherever these come from.

use std::cell::Cell;

use crate::description::expression::{Binary, Condition, Scalar, Unary};
use crate::given::CONSTANT;

use super::number::{NEAR, Number};
use super::tables::{grid, table};

/// Where scalars have their values.
pub trait Values {
    fn scalar(&self, scalar: &Scalar) -> Number;

    /// Told when a condition, a jump or a pole is so near that rounding may take the other side.
    fn near_switch(&self) -> &Cell<bool>;

    /// The operations: everything but names and vectors.
    fn operation(&self, scalar: &Scalar) -> Number {
        let read = |scalar: &Scalar| self.scalar(scalar);
        match scalar {
            Scalar::Literal(literal) => Number::known(literal.value),
            Scalar::Negative(a) => -read(a),
            Scalar::Sum(a, b) => read(a) + read(b),
            Scalar::Difference(a, b) => read(a) - read(b),
            Scalar::Product(a, b) => read(a) * read(b),
            Scalar::Quotient(a, b) => read(a) / self.divisor(read(b)),
            Scalar::Power(a, n) if *n < 0 => self.divisor(read(a)).powi(*n),
            Scalar::Power(a, n) => read(a).powi(*n),
            Scalar::Constant => Number::given(CONSTANT),
            Scalar::Called(a) => {
                let x = read(a);
                x / (Number::ONE + x * x)
            }
            Scalar::Table(a, rows, course) => table(read(a), rows, *course),
            Scalar::Grid(at, values, course) => grid(at.each_ref().map(read), values, *course),
            Scalar::Unary(function, a) => self.unary(*function, read(a)),
            Scalar::Binary(function, a, b) => {
                let (a, b) = (read(a), read(b));
                self.binary(*function, a, b)
            }
            Scalar::If(condition, a, b) => read(if self.holds(condition) { a } else { b }),
            other => unreachable!("{other:?} is read from somewhere"),
        }
    }

    fn unary(&self, function: Unary, x: Number) -> Number {
        match function {
            Unary::Signum | Unary::Recip | Unary::Ln => self.is_near(x),
            Unary::Tan => self.is_near(x.apply(Unary::Cos)),
            Unary::Floor | Unary::Ceil => {
                let whole = Number::given(x.float().round());
                self.is_near(x - whole);
            }
            _ => {}
        }
        x.apply(function)
    }

    fn binary(&self, function: Binary, a: Number, b: Number) -> Number {
        match function {
            // a cut, or a pole
            Binary::Atan2 | Binary::Powf if b.float() < 0.0 => self.is_near(a),
            // the end of the cut
            Binary::Atan2 => self.is_near(a.combine(Binary::Hypot, b)),
            // neither of them where one has no value
            Binary::Min | Binary::Max if (a - b).float().is_nan() => self.near_switch().set(true),
            _ => {}
        }
        a.combine(function, b)
    }

    /// What is divided by: at a pole there is no value, and beside it not one that rounding leaves.
    fn divisor(&self, x: Number) -> Number {
        self.is_near(x);
        x
    }

    fn holds(&self, condition: &Condition) -> bool {
        match condition {
            Condition::Less(a, b) => self.is_less(a, b),
            Condition::AtLeast(a, b) => !self.is_less(a, b),
            Condition::And(a, b) => self.holds(a) & self.holds(b),
            Condition::Or(a, b) => self.holds(a) | self.holds(b),
            Condition::Not(a) => !self.holds(a),
        }
    }

    fn is_less(&self, a: &Scalar, b: &Scalar) -> bool {
        let difference = self.scalar(a) - self.scalar(b);
        self.is_near(difference);
        difference.float() < 0.0
    }

    fn is_near(&self, x: Number) {
        let is_apart = x.float().abs() > NEAR * x.span();
        if !is_apart {
            self.near_switch().set(true);
        }
    }
}
