//! Checks of rows that were not solved for. They allow for rounding, and for the distance of a
//! state from a closed one.

use crate::model::Labels;
use crate::symbolic::{Function, Graph, Id, Number};

use super::super::constraints::ConstraintRow;
use super::rows::Owner;

/// The rounding error that a row may have, relative to its terms.
const ROUNDING: f64 = 1e-12;
/// If a state is off a closed one by some fraction, a row may be off by this multiple of the
/// fraction.
const REACH: i64 = 1 << 10;
/// The size of a joint is at least this fraction of that of all: the rest of it is rounding.
const SMALL: f64 = 1e-3;
/// A row may not be off by more than this fraction of its terms, however far the state is from a
/// closed one.
const MOST: f64 = 0.03;
/// The remainder that is allowed where nothing moves: [m/s^2] or [rad/s^2].
const NOTHING: f64 = 1e-30;

/// The squared distance of a state from a closed one.
pub struct Closeness {
    /// In positions, relative to the size of the system.
    place: Id,
    /// In velocities, relative to the size of the system \[1/s²\].
    rate: Id,
    rates: Vec<Id>,
}

impl Closeness {
    /// Sums over the joints; `is_turning` marks the rotational coordinates, whose slopes are
    /// lengths.
    pub fn of(
        graph: &mut Graph,
        kept: &[(Owner, ConstraintRow)],
        rates: &[Id],
        is_turning: &[bool],
    ) -> Self {
        let mut joints = Vec::new();
        let mut rest = kept;
        while let Some((owner, _)) = rest.first() {
            let own = owner.joint_part(graph);
            let is_same =
                |one: &&(Owner, ConstraintRow)| own.is_some() && one.0.joint_part(graph) == own;
            let count = rest.iter().take_while(is_same).count().max(1);
            let (group, others) = rest.split_at(count);
            rest = others;
            let (mut values, mut fast, mut sizes) = (Vec::new(), Vec::new(), Vec::new());
            for (_, row) in group {
                let turning = row.slopes.iter().zip(is_turning);
                let turning = turning.filter(|(_, is_turning)| **is_turning);
                let mut own_sizes: Vec<Id> =
                    turning.map(|(slope, _)| graph.square(*slope)).collect();
                let terms: Vec<(bool, Id)> =
                    row.value.map_or(Vec::new(), |value| graph.terms(value));
                own_sizes.extend(terms.iter().map(|(_, term)| graph.square(*term)));
                own_sizes.retain(|size| !graph.is_zero(*size));
                // one term has no size but that of the gap, however small that is
                if own.is_none() && own_sizes.len() < 2 {
                    continue;
                }
                sizes.extend(own_sizes);
                fast.push(graph.square(row.rate));
                values.extend(row.gap(graph).map(|value| graph.square(value)));
            }
            let [values, fast, sizes] = [values, fast, sizes].map(|all| graph.sum(&all));
            joints.push((own.map(|(_, is_moment)| is_moment), [values, fast, sizes]));
        }
        let lengths = joints.iter().filter(|(own, _)| *own == Some(false));
        let lengths: Vec<Id> = lengths.map(|(_, [.., size])| *size).collect();
        let lengths = graph.sum(&lengths);
        let [small, nothing] =
            [SMALL, NOTHING].map(|one| graph.number(Number::from_f64(one * one)));
        let short = graph.multiply(small, lengths);
        let short = graph.add(short, nothing);
        let (mut place, mut rate) = (Vec::new(), Vec::new());
        for (own, [values, fast, size]) in joints {
            // all slopes and values of a joint may vanish where it is closed
            let least = match own {
                Some(true) => graph.one(),
                Some(false) => short,
                None => nothing,
            };
            let size = graph.add(size, least);
            let size = graph.quantity(size);
            place.push(graph.divide(values, size));
            rate.push(graph.divide(fast, size));
        }
        let mut whole = |all: &[Id]| {
            let sum = graph.sum(all);
            graph.quantity(sum)
        };
        Self {
            place: whole(&place),
            rate: whole(&rate),
            rates: rates.to_vec(),
        }
    }

    /// Names its parts.
    pub fn label(&self, labels: &mut Labels) {
        labels.name(self.place, "relative_gap_squared");
        labels.name(self.rate, "relative_rate_squared");
    }
}

/// One; or NaN if the squared part that the rows are `lacking` is more than their `terms` allow.
/// `size` is not negative and no constant; it may vanish.
pub fn guard(
    graph: &mut Graph,
    (lacking, terms): (Id, Id),
    (rows, closeness): (&[&ConstraintRow], &Closeness),
    size: Id,
) -> Id {
    let number = |graph: &mut Graph, value: f64| graph.number(Number::from_f64(value));
    let reach = graph.integer(REACH * REACH);
    let rounding = number(graph, ROUNDING * ROUNDING);
    let away = graph.multiply(reach, closeness.place);
    let relative = graph.add(rounding, away);
    let mut allowed = vec![graph.multiply(relative, terms)];
    let mut fast = Vec::new();
    for row in rows {
        for (slope, rate) in row.slopes.iter().zip(&closeness.rates) {
            let moved = graph.multiply(*slope, *rate);
            fast.push(graph.square(moved));
        }
    }
    let fast = graph.sum(&fast);
    let fast = graph.multiply(fast, closeness.rate);
    allowed.push(graph.multiply(reach, fast));
    let (allowed, most) = (graph.sum(&allowed), number(graph, MOST * MOST));
    let most = graph.multiply(most, terms);
    let allowed = graph.apply(Function::Min, &[allowed, most]);
    let nothing = number(graph, NOTHING * NOTHING);
    let allowed = graph.add(allowed, nothing);
    // any positive divisor will do; a rounding error would have no derivatives
    let one = graph.one();
    let divisor = graph.add(one, size);
    // a pivot must exceed eight rounding errors of its size
    let eighth = number(graph, 0.125 / f64::EPSILON);
    let beside = graph.divide(lacking, allowed);
    let beside = graph.multiply(eighth, beside);
    let size = graph.multiply(divisor, beside);
    let inverse = graph.checked_reciprocal(divisor, size);
    graph.multiply(divisor, inverse)
}
