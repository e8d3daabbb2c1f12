//! Partial derivatives.
//!
//! The nodes are walked in the order in which they were made, children first, without recursion,
//! and the results are built by the simplifying constructors.

use super::graph::{Graph, Id, Node};
use super::number::Function;

impl Graph {
    /// The partial derivatives of `roots` with respect to the symbol `by`.
    ///
    /// Steps (`floor`, `ceil`, `signum`) have the derivative zero, and a choice is differentiated
    /// branch by branch.
    pub fn derivative(&mut self, roots: &[Id], by: Id) -> Vec<Id> {
        let order = self.reachable(roots, |_| true);
        let mut derivatives = vec![None; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let derivative = self.differentiate(id, by, |operand| derivatives[operand.index()]);
            derivatives[id.index()] = derivative.filter(|derivative| !self.is_zero(*derivative));
        }
        let zero = self.zero();
        roots
            .iter()
            .map(|root| derivatives[root.index()].unwrap_or(zero))
            .collect()
    }

    /// One step of the chain rule; `None` is zero.
    fn differentiate(&mut self, id: Id, by: Id, known: impl Fn(Id) -> Option<Id>) -> Option<Id> {
        if id == by {
            return Some(self.one());
        }
        let node = self.node(id).clone();
        if node.operands().all(|operand| known(operand).is_none()) {
            return None;
        }
        let zero = self.zero();
        let d = |operand: Id| known(operand).unwrap_or(zero);
        Some(match node {
            Node::Quantity(a) => d(a),
            Node::Negate(a) => self.negate(d(a)),
            Node::Add(a, b) => self.add(d(a), d(b)),
            Node::Subtract(a, b) => self.subtract(d(a), d(b)),
            Node::Multiply(a, b) => {
                let (left, right) = (self.multiply(d(a), b), self.multiply(a, d(b)));
                self.add(left, right)
            }
            Node::Divide(a, b) => {
                // (a / b)' = (a' - (a / b) b') / b
                let change = self.multiply(id, d(b));
                let numerator = self.subtract(d(a), change);
                self.divide(numerator, b)
            }
            Node::Unary(function, a) => {
                let slope = self.slope(function, a, id);
                self.multiply(slope, d(a))
            }
            Node::Binary(function, a, b) => {
                let (by_a, by_b) = self.slopes(function, a, b, id);
                let (left, right) = (self.multiply(by_a, d(a)), self.multiply(by_b, d(b)));
                self.add(left, right)
            }
            Node::Select(condition, a, b) => self.select(condition, d(a), d(b)),
            Node::Number(_)
            | Node::Truth(_)
            | Node::Undefined
            | Node::Symbol(_)
            | Node::Compare(..)
            | Node::And(..)
            | Node::Or(..)
            | Node::Not(_) => return None,
        })
    }

    /// Derivative of a function of one argument at `a`, where its value is `value`.
    fn slope(&mut self, function: Function, a: Id, value: Id) -> Id {
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
    fn slopes(&mut self, function: Function, a: Id, b: Id, value: Id) -> (Id, Id) {
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
                let (low, high) = if function == Function::Min {
                    (a, b)
                } else {
                    (b, a)
                };
                let first = self.compare(super::graph::Comparison::Less, low, high);
                (self.select(first, one, zero), self.select(first, zero, one))
            }
            _ => (zero, zero),
        }
    }
}
