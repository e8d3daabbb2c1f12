//! The reference interpreter: the meaning of a graph, in doubles.

use crate::symbolic::graph::{Comparison, Graph, Id, Node};
use crate::symbolic::number::Function;

impl Graph {
    /// The values of `roots`, with the values of the symbols given by `symbol`.
    pub fn evaluate(&self, roots: &[Id], symbol: impl Fn(Id) -> f64) -> Vec<f64> {
        let order = self.nodes_of(roots);
        let mut values = vec![f64::NAN; order.last().map_or(0, |last| last.index() + 1)];
        for id in order {
            let value = |operand: Id| values[operand.index()];
            let truth = |holds: bool| if holds { 1.0 } else { 0.0 };
            values[id.index()] = match *self.node(id) {
                Node::Number(ref number) => number.to_f64(),
                Node::Truth(holds) => truth(holds),
                // the values of foreign functions are unknown here
                Node::Undefined | Node::Foreign(..) => f64::NAN,
                Node::Symbol(_) => symbol(id),
                Node::Quantity(a) => value(a),
                Node::Positive(a) => positive(value(a)),
                Node::Negate(a) => -value(a),
                Node::Add(a, b) => value(a) + value(b),
                Node::Subtract(a, b) => value(a) - value(b),
                Node::Multiply(a, b) => value(a) * value(b),
                Node::Divide(a, b) => value(a) / value(b),
                Node::Unary(function, a) => unary(function, value(a)),
                Node::Binary(Function::Table, a, table) => {
                    let table = self.table(table);
                    table.map_or(f64::NAN, |table| table.rounded(value(a)))
                }
                Node::Binary(function, a, b) => binary(function, value(a), value(b)),
                Node::Compare(comparison, a, b) => truth(compare(comparison, value(a), value(b))),
                Node::And(a, b) => truth(value(a) != 0.0 && value(b) != 0.0),
                Node::Or(a, b) => truth(value(a) != 0.0 || value(b) != 0.0),
                Node::Not(a) => truth(value(a) == 0.0),
                Node::Pivot(a, _) => value(a).recip(),
                Node::Select(condition, a, b) => value(if value(condition) == 0.0 { b } else { a }),
            };
        }
        roots.iter().map(|root| values[root.index()]).collect()
    }
}

fn positive(a: f64) -> f64 {
    if a > 0.0 { a } else { f64::NAN }
}

pub(in crate::symbolic) fn unary(function: Function, a: f64) -> f64 {
    match function {
        Function::Sqrt => a.sqrt(),
        Function::Cbrt => a.cbrt(),
        Function::Exp => a.exp(),
        Function::Ln => a.ln(),
        Function::Sin => a.sin(),
        Function::Cos => a.cos(),
        Function::Tan => a.tan(),
        Function::Asin => a.asin(),
        Function::Acos => a.acos(),
        Function::Atan => a.atan(),
        Function::Sinh => a.sinh(),
        Function::Cosh => a.cosh(),
        Function::Tanh => a.tanh(),
        Function::Abs => a.abs(),
        Function::Signum => a.signum(),
        Function::Floor => a.floor(),
        Function::Ceil => a.ceil(),
        _ => f64::NAN,
    }
}

pub(in crate::symbolic) fn binary(function: Function, a: f64, b: f64) -> f64 {
    match function {
        Function::Atan2 => a.atan2(b),
        Function::Powf => a.powf(b),
        Function::Hypot => a.hypot(b),
        Function::Min => a.min(b),
        Function::Max => a.max(b),
        _ => f64::NAN,
    }
}

#[allow(clippy::float_cmp, reason = "the user wrote this comparison")]
fn compare(comparison: Comparison, a: f64, b: f64) -> bool {
    match comparison {
        Comparison::Less => a < b,
        Comparison::LessOrEqual => a <= b,
        Comparison::Equal => a == b,
        Comparison::NotEqual => a != b,
    }
}
