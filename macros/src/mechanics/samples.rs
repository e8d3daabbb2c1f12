//! Exact values at random states: what they say of a rank, it is for almost all states.

use std::collections::HashMap;

use crate::model::{Meaning, Model};
use crate::symbolic::{Id, Node, Number};

/// States that are tried until all expressions have a value.
const TRIES: i64 = 8;
/// From this seed on, half of the numbers are negative.
pub const MIXED: i64 = 1000;

/// The values of `roots` at one state. Rational functions are exact, all others to 200 bits.
pub fn sample(model: &mut Model, roots: &[Id]) -> Vec<Number> {
    let mut values = Vec::new();
    for seed in 1..=TRIES {
        values = at_state(model, roots, seed);
        if values.iter().all(Option::is_some) {
            break;
        }
    }
    // what has no value anywhere does not vanish
    let values = values.into_iter();
    values
        .map(|value| value.unwrap_or_else(Number::one))
        .collect()
}

/// Which of `roots` are zero in all states, on all branches, and for numbers of either sign.
pub fn vanish(model: &mut Model, roots: &[Id]) -> Vec<bool> {
    let mixed = model.frames.graph.unbranched(roots);
    let positive = sample(model, &mixed);
    let mut vanish: Vec<bool> = positive.iter().map(Number::is_zero).collect();
    for seed in [1, 2].map(|seed| MIXED + seed) {
        if vanish.contains(&true) {
            let values = at_state(model, &mixed, seed);
            for (vanishes, value) in vanish.iter_mut().zip(values) {
                *vanishes &= value.is_none_or(|value| value.is_zero());
            }
        }
    }
    vanish
}

/// The values of `roots` at the state of this number; `None` where there is no value.
pub fn at_state(model: &mut Model, roots: &[Id], seed: i64) -> Vec<Option<Number>> {
    let graph = &mut model.frames.graph;
    let quaternion = unit_quaternion(seed);
    let (axis, rate) = axis_and_rate(seed);
    let mut numbers = HashMap::new();
    for id in graph.reachable(roots, |_| true) {
        let Node::Symbol(symbol) = *graph.node(id) else {
            continue;
        };
        let value = match model.meanings.of(symbol) {
            Meaning::Quaternion(part) => quaternion[part].clone(),
            Meaning::Axis(part) => axis[part].clone(),
            Meaning::AxisRate(part) => rate[part].clone(),
            _ => fraction(i64::from(symbol.0), seed),
        };
        numbers.insert(id, graph.number(value));
    }
    let images = graph.substitute(roots, |id| numbers.get(&id).copied());
    let values = images
        .into_iter()
        .map(|image| graph.as_number(image).cloned());
    values.collect()
}

/// Between 0 and 1, or -1 and 1, different for each symbol and each try.
fn fraction(index: i64, seed: i64) -> Number {
    let numerator = (7919 * (index + 3) + 104_729 * seed) % 65_521 + 1;
    let is_negative = seed > MIXED && numerator % 2 == 1;
    Number::ratio(if is_negative { -numerator } else { numerator }, 65_537)
}

/// `(1 - s^2, 2 s) / (1 + s^2)` of a vector s: the stereographic projection.
fn unit_quaternion(seed: i64) -> [Number; 4] {
    let s = [101, 102, 103].map(|index| fraction(index, seed));
    let square = s.iter().fold(Number::zero(), |sum, part| {
        sum + part.clone() * part.clone()
    });
    let (above, below) = (Number::one() - square.clone(), Number::one() + square);
    let over = |number: Number| number.checked_div(&below).unwrap_or_else(Number::zero);
    let [x, y, z] = s.map(|part| over(Number::integer(2) * part));
    [over(above), x, y, z]
}

/// A unit vector, `q e_x q*` of a unit quaternion, and a vector perpendicular to it.
fn axis_and_rate(seed: i64) -> ([Number; 3], [Number; 3]) {
    let [w, x, y, z] = unit_quaternion(seed);
    let product = |a: &Number, b: &Number| a.clone() * b.clone();
    let twice = |number: Number| Number::integer(2) * number;
    let (yy_zz, xy_wz, xz_wy) = (
        product(&y, &y) + product(&z, &z),
        product(&x, &y) + product(&w, &z),
        product(&x, &z) - product(&w, &y),
    );
    let axis = [Number::one() - twice(yy_zz), twice(xy_wz), twice(xz_wy)];
    let any = [104, 105, 106].map(|index| fraction(index, seed));
    let crossed = |i: usize, j: usize| product(&axis[i], &any[j]) - product(&axis[j], &any[i]);
    let rate = [crossed(1, 2), crossed(2, 0), crossed(0, 1)];
    (axis, rate)
}
