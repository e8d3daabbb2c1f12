//! The slopes of functions, along each of their arguments.

use core::slice::from_ref;

use crate::symbolic::graph::Comparison;
use crate::symbolic::number::{Function, Number};

use super::operations::Algebra;

/// The derivative of a function of one argument at `a`, where its value is `value`.
pub fn slope<A: Algebra>(
    of: &mut A,
    function: Function,
    a: &A::Value,
    value: &A::Value,
) -> A::Value {
    let one = of.one();
    match function {
        Function::Sqrt => {
            let twice = of.add(value, value);
            of.divide(&one, &twice)
        }
        Function::Cbrt => {
            let square = of.square(value);
            let three = of.number(&Number::integer(3));
            let thrice = of.multiply(&three, &square);
            of.divide(&one, &thrice)
        }
        Function::Exp => value.clone(),
        Function::Ln => of.divide(&one, a),
        Function::Sin => of.apply(Function::Cos, from_ref(a)),
        Function::Cos => {
            let sine = of.apply(Function::Sin, from_ref(a));
            of.negate(&sine)
        }
        Function::Tan => {
            let square = of.square(value);
            of.add(&one, &square)
        }
        Function::Asin | Function::Acos => {
            let square = of.square(a);
            let rest = of.subtract(&one, &square);
            let root = of.apply(Function::Sqrt, &[rest]);
            let slope = of.divide(&one, &root);
            if function == Function::Asin {
                slope
            } else {
                of.negate(&slope)
            }
        }
        Function::Atan => {
            let square = of.square(a);
            let sum = of.add(&one, &square);
            of.divide(&one, &sum)
        }
        Function::Sinh => of.apply(Function::Cosh, from_ref(a)),
        Function::Cosh => of.apply(Function::Sinh, from_ref(a)),
        Function::Tanh => {
            let square = of.square(value);
            of.subtract(&one, &square)
        }
        Function::Abs => of.apply(Function::Signum, from_ref(a)),
        _ => of.zero(),
    }
}

/// The derivatives of a function of two arguments with respect to each of them.
pub fn slopes<A: Algebra>(
    of: &mut A,
    function: Function,
    a: &A::Value,
    b: &A::Value,
    value: &A::Value,
) -> (A::Value, A::Value) {
    let (zero, one) = (of.zero(), of.one());
    match function {
        Function::Hypot => (of.divide(a, value), of.divide(b, value)),
        Function::Atan2 => {
            let (squared_a, squared_b) = (of.square(a), of.square(b));
            let sum = of.add(&squared_a, &squared_b);
            let (by_a, by_b) = (of.divide(b, &sum), of.divide(a, &sum));
            (by_a, of.negate(&by_b))
        }
        Function::Powf => {
            let less = of.subtract(b, &one);
            let power = of.apply(Function::Powf, &[a.clone(), less]);
            let logarithm = of.apply(Function::Ln, from_ref(a));
            let by_a = of.multiply(b, &power);
            let by_b = of.multiply(value, &logarithm);
            (along(of, b, &zero, &by_a), along(of, value, &zero, &by_b))
        }
        // the derivative of a table is a table, too
        Function::Table => {
            let next = of.add(b, &one);
            (of.apply(Function::Table, &[a.clone(), next]), zero)
        }
        Function::Min | Function::Max => {
            let first = takes_first(of, function, a, b);
            (
                of.select(&first, &one, &zero),
                of.select(&first, &zero, &one),
            )
        }
        _ => (zero.clone(), zero),
    }
}

/// A product with this factor: zero if the factor is, even where the other is infinite.
fn along<A: Algebra>(
    of: &mut A,
    factor: &A::Value,
    zero: &A::Value,
    product: &A::Value,
) -> A::Value {
    let is_zero = of.compare(Comparison::Equal, factor, zero);
    of.select(&is_zero, zero, product)
}

/// Whether `min` or `max` of `a` and `b` is `a`.
pub fn takes_first<A: Algebra>(
    of: &mut A,
    function: Function,
    a: &A::Value,
    b: &A::Value,
) -> A::Value {
    let (low, high) = if function == Function::Min {
        (a, b)
    } else {
        (b, a)
    };
    of.compare(Comparison::Less, low, high)
}
