//! Values at random states: what they say of zeros and of a rank, it is for almost all states.

use std::hash::{DefaultHasher, Hash, Hasher};

use crate::model::{Meaning, Model};
use crate::symbolic::{Algebra, Doubles, Exact, Id, Node, Number, Residues, Tape};

/// States that are tried until all expressions have a value.
const TRIES: u64 = 8;

/// States with numbers of either sign; each number has one sign in the first of two, the other in the second.
pub const SIGNS: u64 = 8;

/// Numbers before this one make the attitude.
const OTHERS: u64 = 8;

/// Of fractions; a prime beyond 2^20.
const DENOMINATOR: u64 = (1 << 20) + 7;

/// What the numbers of a state are drawn from.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub enum Range {
    /// Between 0 and 1.
    Positive,
    /// Between -1 and 1.
    Mixed,
    /// Integers of any size, for arithmetic modulo a prime.
    Integers,
}

/// The values of `roots` at one state. Rational functions are exact, all others to 200 bits.
pub fn sample(model: &Model, roots: &[Id]) -> Vec<Number> {
    let tape = model.frames.graph.tape(roots);
    let mut values = Vec::new();
    for seed in 1..=TRIES {
        let all = at_state(model, &tape, &mut Exact, Range::Positive, seed);
        values = roots
            .iter()
            .map(|root| tape.of(&all, *root).clone())
            .collect();
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
    let roots = model.frames.graph.unbranched(roots);
    let tape = model.frames.graph.tape(&roots);
    let mut residues = Residues::default();
    let formal = at_state(model, &tape, &mut residues, Range::Integers, 1);
    // residues do not know the sign of a root, nor a prime from zero
    let mut near = vec![at_state(model, &tape, &mut Doubles, Range::Positive, 1)];
    if !residues.is_final() {
        let mixed = |seed| at_state(model, &tape, &mut Doubles, Range::Mixed, seed);
        near.extend((1..=SIGNS).map(mixed));
    }
    let is_not_zero = |root: &Id| {
        near.iter()
            .any(|all| Doubles.is_not_zero(tape.of(all, *root)))
    };
    let is_zero = |root: &Id| residues.is_zero(tape.of(&formal, *root)) && !is_not_zero(root);
    let mut vanish: Vec<bool> = roots.iter().map(is_zero).collect();
    if residues.is_final() && roots.iter().all(|root| tape.of(&formal, *root).is_some()) {
        return vanish;
    }
    let is_open = |index: &usize| !vanish[*index] && !is_not_zero(&roots[*index]);
    let open: Vec<usize> = (0..roots.len()).filter(is_open).collect();
    let exact: Vec<Id> = open.iter().map(|index| roots[*index]).collect();
    for (index, vanishes) in open.into_iter().zip(vanish_exactly(model, &exact)) {
        vanish[index] = vanishes;
    }
    vanish
}

/// The same of expressions whose zeros residues and doubles do not tell.
fn vanish_exactly(model: &Model, roots: &[Id]) -> Vec<bool> {
    let mut vanish: Vec<bool> = sample(model, roots).iter().map(Number::is_zero).collect();
    let tape = model.frames.graph.tape(roots);
    for seed in 1..=2 {
        if vanish.contains(&true) {
            let all = at_state(model, &tape, &mut Exact, Range::Mixed, seed);
            for (vanishes, root) in vanish.iter_mut().zip(roots) {
                *vanishes &= !Exact.is_not_zero(tape.of(&all, *root));
            }
        }
    }
    vanish
}

/// The values of all expressions of a tape at the state of this number.
pub fn at_state<A: Algebra>(
    model: &Model,
    tape: &Tape<'_>,
    algebra: &mut A,
    range: Range,
    seed: u64,
) -> Vec<A::Value> {
    let graph = &model.frames.graph;
    let mut drawn = |index: u64| algebra.number(&draw(range, seed, index));
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(&mut drawn);
    let any = [5, 6, 7].map(drawn);
    let quaternion = unit_vector(algebra, &[a, b, c]);
    let axis = unit_vector(algebra, &[d, e]);
    let rate = cross(algebra, &axis, &any);
    tape.values(algebra, |algebra, id| {
        let Node::Symbol(symbol) = *graph.node(id) else {
            return algebra.undefined();
        };
        match model.meanings.of(symbol) {
            Meaning::Quaternion(part) => quaternion[part].clone(),
            Meaning::Axis(part) => axis[part].clone(),
            Meaning::AxisRate(part) => rate[part].clone(),
            _ => algebra.number(&draw(range, seed, OTHERS + u64::from(symbol.0))),
        }
    })
}

/// Different for each symbol and each try, and without any relation between them.
fn draw(range: Range, seed: u64, index: u64) -> Number {
    let random = |seed: u64| {
        let mut hasher = DefaultHasher::new();
        (range, seed, index).hash(&mut hasher);
        hasher.finish()
    };
    let integer = |bits: u32| i64::try_from(random(seed) >> (u64::BITS - bits)).unwrap_or(1);
    let sign = if (random(seed.div_ceil(2)) + seed) % 2 == 1 {
        -1
    } else {
        1
    };
    match range {
        Range::Integers => Number::integer(integer(60)),
        Range::Positive => Number::ratio(integer(20) + 1, DENOMINATOR),
        Range::Mixed => Number::ratio(sign * (integer(20) + 1), DENOMINATOR),
    }
}

/// `(1 - s^2, 2 s) / (1 + s^2)` of a vector s: a unit vector of one more dimension, by stereographic
/// projection.
fn unit_vector<A: Algebra, const N: usize>(algebra: &mut A, s: &[A::Value; N]) -> Vec<A::Value> {
    let one = algebra.one();
    let mut square = algebra.zero();
    for part in s {
        let part = algebra.square(part);
        square = algebra.add(&square, &part);
    }
    let (above, below) = (algebra.subtract(&one, &square), algebra.add(&one, &square));
    let scale = algebra.divide(&one, &below);
    let twice = s.each_ref().map(|part| algebra.add(part, part));
    let parts = core::iter::once(above).chain(twice);
    parts.map(|part| algebra.multiply(&part, &scale)).collect()
}

fn cross<A: Algebra>(algebra: &mut A, a: &[A::Value], b: &[A::Value]) -> [A::Value; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (left, right) = (
            algebra.multiply(&a[i], &b[j]),
            algebra.multiply(&a[j], &b[i]),
        );
        algebra.subtract(&left, &right)
    })
}
