//! Closed states, found numerically with the defaults of parameters, and the number of rows that
//! are independent in these states and remain so in motion. This only selects a form of the
//! equations; nothing is claimed because of it.

use std::collections::HashMap;

use crate::mechanics::system::constraints::ConstraintRow;
use crate::mechanics::tree::MassMatrix;
use crate::model::{System, TreeJoint, Variable, Workspace};
use crate::symbolic::{Coordinate, Id};

use super::numbers::{Random, Span, bounded, is_positive, solve, squares};
use super::part::Part;

/// The number of initial states, and the most steps from each.
const STARTS: u64 = 24;
const STEPS: usize = 60;
/// The initial states that show the size of slopes.
const GENERIC: u64 = 4;
/// A slope is nothing if it is less than this fraction of its terms.
const NOTHING: f64 = 1e-9;
/// How far a closed state is displaced to see whether it can move.
const MOVED: f64 = 0.05;

/// How a state changes, apart from prescribed motions.
pub struct Coordinates {
    /// The rates of the open coordinates.
    pub rates: Vec<Id>,
    /// The coordinates of a state, with their rates.
    pub places: Vec<Coordinate>,
}

/// The rows, and the coordinates that they depend on.
pub struct Assembly<'a> {
    work: &'a Workspace,
    rows: Vec<&'a ConstraintRow>,
    rates: &'a [Id],
    coordinates: &'a [Coordinate],
    attitudes: Vec<[Id; 4]>,
    defaults: HashMap<Id, f64>,
    /// The largest of the terms of each slope in a few states.
    terms: Vec<Vec<f64>>,
    parts: Vec<Part>,
}

/// For each row, whether it is independent of the rows before it.
#[derive(Default)]
pub struct Rank {
    /// In almost all states; `None` if there are no rows to tell.
    pub anywhere: Option<Vec<bool>>,
    /// In closed states; `None` if none was found.
    pub closed: Option<Vec<bool>>,
    /// Whether the masses and some of the rows determine the motion in a closed state.
    pub is_settled: bool,
}

impl Rank {
    /// What is independent on one of two branches, if it is known on both.
    pub fn or(self, other: Self) -> Self {
        let either = |a: Option<Vec<bool>>, b: Option<Vec<bool>>| {
            let both = a?.into_iter().zip(b?);
            Some(both.map(|(a, b)| a || b).collect())
        };
        Self {
            is_settled: self.is_settled && other.is_settled,
            anywhere: either(self.anywhere, other.anywhere),
            closed: either(self.closed, other.closed),
        }
    }
}

/// The values of symbols.
type Values = HashMap<Id, f64>;

impl<'a> Assembly<'a> {
    pub fn new(
        system: &System,
        work: &'a Workspace,
        coordinates: &'a Coordinates,
        (rows, terms): (Vec<&'a ConstraintRow>, &[Id]),
    ) -> Self {
        let open = system.joints.iter().filter(|joint| !joint.is_driven());
        let attitude = |joint: &TreeJoint| {
            let part = |part: usize| joint.coordinates.get(Variable::Quaternion, part);
            Some([part(0)?, part(1)?, part(2)?, part(3)?])
        };
        let defaults = system.defaults.iter();
        let defaults = defaults
            .filter_map(|(symbol, value)| Some((*symbol, work.graph.as_number(*value)?.to_f64())));
        let mut assembly = Self {
            terms: vec![vec![0.0; coordinates.rates.len()]; rows.len()],
            parts: Vec::new(),
            rows,
            rates: &coordinates.rates,
            coordinates: &coordinates.places,
            attitudes: open.filter_map(attitude).collect(),
            defaults: defaults.collect(),
            work,
        };
        let generic = assembly.generic();
        for values in &generic {
            let found = assembly.evaluate(terms, values);
            let sizes = assembly.terms.iter_mut().flatten();
            for (size, term) in sizes.zip(found) {
                *size = size.max(term.abs());
            }
        }
        let mut held = vec![vec![false; coordinates.rates.len()]; assembly.rows.len()];
        for values in &generic {
            let slopes = assembly.rounded_slopes(values).into_iter().flatten();
            for (is_held, slope) in held.iter_mut().flatten().zip(slopes) {
                *is_held |= slope != 0.0;
            }
        }
        assembly.parts = Part::all(held);
        assembly
    }

    /// A few states that are not closed.
    fn generic(&self) -> Vec<Values> {
        let starts = 0..GENERIC;
        starts
            .map(|start| self.start(&mut Random::new(start), start))
            .collect()
    }

    /// Which rows depend on others, in almost all states and in closed states. Where rows are
    /// independent, `some` selects those that are to determine the motion, with the masses. Of rows
    /// that are made of pieces, and others with them, those count that are independent in one of
    /// the closed states.
    pub fn rank(
        &self,
        matrix: &MassMatrix,
        some: impl Fn(&[bool]) -> Vec<usize>,
        are_pieces: &[bool],
    ) -> Rank {
        // without open coordinates, nothing moves
        if self.rates.is_empty() {
            return Rank::default();
        }
        let generic = self.generic().into_iter();
        let generic = generic.map(|values| self.independent_at(&values));
        let anywhere = generic.max_by_key(|found| count(found));
        let begun = (0..STARTS).map(|start| (start, Random::new(start)));
        let closed = begun.filter_map(|(start, mut random)| {
            let mut values = self.start(&mut random, start);
            self.close(&mut values)?;
            Some((self.independent_at(&values), values, random))
        });
        let mut closed: Vec<(Vec<bool>, Values, Random)> = closed.collect();
        let parts = self.parts.iter();
        let parts = parts.map(|part| self.best(part, &mut closed, are_pieces));
        let closed = parts.collect::<Option<Vec<_>>>().map(|parts| {
            let any = |row: usize| parts.iter().any(|(found, _)| found[row]);
            let all: Vec<bool> = (0..self.rows.len()).map(any).collect();
            let some = some(&all);
            let mut states = parts.iter().map(|(_, values)| values);
            let is_settled = states.any(|values| self.is_settled(values, matrix, &some));
            (all, is_settled)
        });
        Rank {
            is_settled: closed.as_ref().is_some_and(|(_, is_settled)| *is_settled),
            closed: closed.map(|(all, _)| all),
            anywhere,
        }
    }

    /// The independent rows of a part in the generic one of these closed states, and that state.
    fn best(
        &self,
        part: &Part,
        closed: &mut [(Vec<bool>, Values, Random)],
        are_pieces: &[bool],
    ) -> Option<(Vec<bool>, Values)> {
        let able = closed.iter_mut().filter_map(|(found, values, random)| {
            let moves = self.moves(part, values, random)?;
            Some((moves, &*found, &*values))
        });
        let able: Vec<(usize, &Vec<bool>, &Values)> = able.collect();
        // folded states have fewer independent rows, but the generic closed state is wanted; rows
        // that hold more in place may be those of another assembly, which does not move
        let best = able.iter();
        let best = best.max_by_key(|(moves, found, _)| (*moves, part.count(found)));
        let (_, best, values) = best?;
        let has_pieces = part.rows.iter().any(|row| are_pieces[*row]);
        let is_new = |row: usize| {
            let somewhere = || able.iter().any(|(_, found, _)| found[row]);
            part.rows.contains(&row) && (best[row] || has_pieces && somewhere())
        };
        let found = (0..self.rows.len()).map(is_new).collect();
        Some((found, (*values).clone()))
    }

    /// Whether M and these rows determine the motion in a state: `M + A^T W A` is positive.
    fn is_settled(&self, values: &Values, matrix: &MassMatrix, rows: &[usize]) -> bool {
        let entries: Vec<Id> = matrix.rows.concat();
        let count = self.rates.len();
        let entries = self.evaluate(&entries, values);
        let mut all: Vec<Vec<f64>> = entries.chunks(count).map(<[f64]>::to_vec).collect();
        let slopes = self.rounded_slopes(values);
        let sizes: Vec<f64> = (0..count)
            .map(|own| all[own][own].max(f64::MIN_POSITIVE).sqrt())
            .collect();
        for (row, masses) in all.iter_mut().enumerate() {
            for (entry, column) in masses.iter_mut().zip(&sizes) {
                *entry /= sizes[row] * column;
            }
        }
        for row in rows {
            let row: Vec<f64> = slopes[*row]
                .iter()
                .zip(&sizes)
                .map(|(slope, size)| slope / size)
                .collect();
            let weight = 1.0 / squares(&row).max(f64::MIN_POSITIVE);
            for (own, slope) in row.iter().enumerate() {
                for (other, factor) in row.iter().enumerate() {
                    all[own][other] += weight * slope * factor;
                }
            }
        }
        is_positive(all)
    }

    fn start(&self, random: &mut Random, number: u64) -> Values {
        let scale = [1.0, 0.3, 0.1, 2.0][usize::try_from(number % 4).unwrap_or(0)];
        let mut values = self.defaults.clone();
        for coordinate in self.coordinates {
            values.insert(coordinate.symbol, scale * random.number());
        }
        // bodies are often described as assembled
        if scale < 1.0 {
            for [real, ..] in &self.attitudes {
                values.entry(*real).and_modify(|part| *part += 1.0);
            }
        }
        self.normalize(&mut values);
        values
    }

    fn normalize(&self, values: &mut Values) {
        for attitude in &self.attitudes {
            let parts = attitude.map(|part| values.get(&part).copied().unwrap_or(0.0));
            let norm = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
            for (symbol, part) in attitude.iter().zip(parts) {
                values.insert(*symbol, part / norm);
            }
        }
    }

    /// The values of `roots`. Unknown symbols get arbitrary constant values.
    fn evaluate(&self, roots: &[Id], values: &Values) -> Vec<f64> {
        self.work.graph.evaluate(roots, |id| {
            let known = values.get(&id).copied();
            known.unwrap_or_else(|| 1.0 + 0.5 * Random::new(id.index() as u64).number())
        })
    }

    /// The rows in a state.
    fn slopes(&self, values: &Values) -> Vec<Vec<f64>> {
        let all: Vec<Id> = self
            .rows
            .iter()
            .flat_map(|row| row.slopes.clone())
            .collect();
        let all = self.evaluate(&all, values);
        all.chunks(self.rates.len().max(1))
            .map(<[f64]>::to_vec)
            .collect()
    }

    /// The rows in a state. Slopes that only rounding keeps from being zero are zero.
    fn rounded_slopes(&self, values: &Values) -> Vec<Vec<f64>> {
        let mut slopes = self.slopes(values);
        let own = slopes.iter_mut().flatten();
        for (slope, size) in own.zip(self.terms.iter().flatten()) {
            if slope.abs() < NOTHING * size {
                *slope = 0.0;
            }
        }
        slopes
    }

    /// Whether each row is independent of the rows before it. The slopes along each coordinate are
    /// divided by the largest of them, because a distant point has large slopes along angles.
    fn independent_at(&self, values: &Values) -> Vec<bool> {
        let mut rows = self.rounded_slopes(values);
        for freedom in 0..self.rates.len() {
            let entries = rows.iter().map(|row| row[freedom].abs());
            let largest = entries.fold(f64::MIN_POSITIVE, f64::max);
            for row in &mut rows {
                row[freedom] /= largest;
            }
        }
        let mut span = Span::default();
        rows.into_iter().map(|row| span.take(row)).collect()
    }

    /// Finds a nearby closed state by damped Newton steps, and returns the displacement of each
    /// coordinate.
    fn close(&self, values: &mut Values) -> Option<Vec<f64>> {
        // nothing closes what is constant
        let is_held = |row: &usize| self.terms[*row].iter().any(|term| *term > 0.0);
        let held = (0..self.rows.len()).filter(is_held);
        let held = held.filter_map(|row| Some((row, self.rows[row].value?)));
        let (held, roots): (Vec<usize>, Vec<Id>) = held.unzip();
        let mut all = vec![0.0; self.rates.len()];
        let diagonal: Vec<f64> = (0..all.len())
            .map(|own| self.size_along(&held, own))
            .collect();
        let mut damping = 1e-3;
        let mut errors = self.evaluate(&roots, values);
        for _ in 0..STEPS {
            let slopes = self.slopes(values);
            let slopes: Vec<Vec<f64>> = held.iter().map(|row| slopes[*row].clone()).collect();
            let step = bounded(solve(&slopes, &errors, (damping, &diagonal)), &errors);
            let moved = self.moved(values, &step);
            let next = self.evaluate(&roots, &moved);
            if squares(&next) < squares(&errors) {
                damping *= 0.1;
                (*values, errors) = (moved, next);
                for (sum, part) in all.iter_mut().zip(step) {
                    *sum += part;
                }
            } else if squares(&errors).sqrt() < 1e-13 * size(&slopes) {
                break;
            } else {
                damping *= 10.0;
            }
        }
        let is_closed = squares(&errors).sqrt() < 1e-12 * size(&self.slopes(values));
        let facing: Vec<Id> = self.rows.iter().filter_map(|row| row.facing).collect();
        let cosines = self.evaluate(&facing, values);
        let is_meant = cosines.into_iter().all(|cosine| cosine > 0.5);
        (is_closed && is_meant).then_some(all)
    }

    /// The squares of the terms of rows along a coordinate; one if there are none.
    fn size_along(&self, rows: &[usize], coordinate: usize) -> f64 {
        let terms = rows.iter().map(|row| self.terms[*row][coordinate]);
        let size = squares(&terms.collect::<Vec<f64>>());
        if size > 0.0 { size } else { 1.0 }
    }

    /// The state with its coordinates changed by these amounts.
    fn moved(&self, values: &Values, step: &[f64]) -> Values {
        let mut rates = values.clone();
        rates.extend(self.rates.iter().copied().zip(step.iter().copied()));
        let roots: Vec<Id> = self.coordinates.iter().map(|one| one.rate).collect();
        let changes = self.evaluate(&roots, &rates);
        let mut moved = values.clone();
        for (coordinate, change) in self.coordinates.iter().zip(changes) {
            if let Some(value) = moved.get_mut(&coordinate.symbol) {
                *value += change;
            }
        }
        self.normalize(&mut moved);
        moved
    }

    /// The number of coordinates of a part that change as it moves on to a state with equally many
    /// independent rows; none if its rows hold all of them in place. `None` if it is neither.
    fn moves(&self, part: &Part, values: &Values, random: &mut Random) -> Option<usize> {
        let slopes = self.rounded_slopes(values);
        let mut span = Span::default();
        for row in &part.rows {
            span.take(slopes[*row].clone());
        }
        let held = part.held.iter();
        let way = held.map(|is_held| if *is_held { random.number() } else { 0.0 });
        let Some(way) = span.left(way.collect()) else {
            return (span.rank() == count(&part.held)).then_some(0);
        };
        let moving = way.iter().filter(|part| part.abs() > NOTHING).count();
        let step: Vec<f64> = way.iter().map(|part| MOVED * part).collect();
        let mut moved = self.moved(values, &step);
        let back = self.close(&mut moved)?;
        let back: f64 = back.iter().zip(&way).map(|(a, b)| a * b).sum();
        let ranks = [values, &moved].map(|values| part.count(&self.independent_at(values)));
        (back > -0.5 * MOVED && ranks[0] == ranks[1]).then_some(moving)
    }
}

fn count(found: &[bool]) -> usize {
    found.iter().filter(|is_new| **is_new).count()
}

/// The size of the largest row.
fn size(slopes: &[Vec<f64>]) -> f64 {
    let sizes = slopes.iter().map(|row| squares(row).sqrt());
    sizes.fold(0.0, f64::max)
}
