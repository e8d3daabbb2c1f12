//! The slopes of functions, along each of their arguments.

use super::function::Function;
use super::graph::{Comparison, Graph, Id};

impl Graph {
    /// Derivative of a function of one argument at `a`, where its value is `value`.
    pub(super) fn slope(&mut self, function: Function, a: Id, value: Id) -> Id {
        let one = self.one();
        let square = self.square(a);
        match function {
            Function::Sqrt => {
                let twice = self.add(value, value);
                self.divide(one, twice)
            }
            Function::Cbrt => {
                let square = self.square(value);
                let three = self.integer(3);
                let thrice = self.multiply(three, square);
                self.divide(one, thrice)
            }
            Function::Exp => value,
            Function::Ln => self.divide(one, a),
            Function::Sin => self.apply(Function::Cos, &[a]),
            Function::Cos => {
                let sine = self.apply(Function::Sin, &[a]);
                self.negate(sine)
            }
            Function::Tan => {
                let square = self.square(value);
                self.add(one, square)
            }
            Function::Asin | Function::Acos => {
                let rest = self.subtract(one, square);
                let root = self.apply(Function::Sqrt, &[rest]);
                let slope = self.divide(one, root);
                if function == Function::Asin {
                    slope
                } else {
                    self.negate(slope)
                }
            }
            Function::Atan => {
                let sum = self.add(one, square);
                self.divide(one, sum)
            }
            Function::Sinh => self.apply(Function::Cosh, &[a]),
            Function::Cosh => self.apply(Function::Sinh, &[a]),
            Function::Tanh => {
                let square = self.square(value);
                self.subtract(one, square)
            }
            Function::Abs => self.apply(Function::Signum, &[a]),
            _ => self.zero(),
        }
    }

    /// Derivatives of a function of two arguments by each of them.
    pub(super) fn slopes(&mut self, function: Function, a: Id, b: Id, value: Id) -> (Id, Id) {
        let (zero, one) = (self.zero(), self.one());
        match function {
            Function::Hypot => (self.divide(a, value), self.divide(b, value)),
            Function::Atan2 => {
                let (squared_a, squared_b) = (self.square(a), self.square(b));
                let sum = self.add(squared_a, squared_b);
                let (by_a, by_b) = (self.divide(b, sum), self.divide(a, sum));
                (by_a, self.negate(by_b))
            }
            Function::Powf => {
                let less = self.subtract(b, one);
                let power = self.apply(Function::Powf, &[a, less]);
                let logarithm = self.apply(Function::Ln, &[a]);
                (self.multiply(b, power), self.multiply(value, logarithm))
            }
            Function::Min | Function::Max => {
                let first = self.takes_first(function, a, b);
                (self.select(first, one, zero), self.select(first, zero, one))
            }
            _ => (zero, zero),
        }
    }

    /// Whether `min` or `max` of `a` and `b` is `a`.
    pub(super) fn takes_first(&mut self, function: Function, a: Id, b: Id) -> Id {
        let (low, high) = if function == Function::Min {
            (a, b)
        } else {
            (b, a)
        };
        self.compare(Comparison::Less, low, high)
    }
}
