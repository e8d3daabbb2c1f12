//! Linear equations with expressions as coefficients, solved by elimination.
//!
//! What vanishes is proved: every row carries its coefficients at one random state, on each branch, and
//! they are eliminated along with it. Pivots are what vanishes on no branch, and of these ones before
//! numbers before what is positive by its structure, there first what is known early; a division by
//! what depends on the configuration is guarded ([`Graph::pivot`]). Where all that is left may
//! vanish in some state, or for some parameters, though the equations are regular there, no pivot is
//! chosen: [`super::determinant`].
//!
//! An equation that says nothing on some branch has the solution zero there for the unknown that it is
//! solved for.

use crate::symbolic::graph::{Graph, Id, Node};
use crate::symbolic::number::Number;
use crate::symbolic::zeros::Sample;

use super::sizes::Size;

/// `sum of coefficients * unknowns = right`
#[derive(Clone)]
pub struct Equation {
    pub coefficients: Vec<Id>,
    pub right: Id,
    /// The coefficients at a random state.
    pub sample: Vec<Sample>,
    /// Where it says something, if that is not everywhere.
    pub active: Option<Id>,
    /// What is known of each coefficient.
    pub sizes: Vec<Size>,
}

/// What equations say of their unknowns.
pub struct Elimination {
    /// The value of each unknown; that of an undetermined one is zero.
    pub values: Vec<Id>,
    /// The guarded reciprocals, each with the unknown that it gives.
    pub pivots: Vec<(usize, Id)>,
    /// The unknowns that the equations do not determine.
    pub undetermined: Vec<Undetermined>,
    /// The rows that are left over, with what is left of their right sides.
    pub spare: Vec<(usize, Id)>,
}

/// An unknown that is determined only together with others.
pub struct Undetermined {
    pub column: usize,
    /// Those that can do all that it does.
    pub others: Vec<usize>,
    /// A sum that is determined, of unknowns with factors, itself among them; by itself if there are
    /// no others.
    pub sum: Vec<(usize, Id)>,
}

/// What may be a pivot, the best first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    One,
    Number,
    EarlySquares,
    Squares,
    /// It may vanish in some state or for some parameters, or is small beside others.
    Unsafe,
}

impl Kind {
    /// Whether it is large in all states.
    fn is_safe(self) -> bool {
        self <= Self::Squares
    }
}

/// So many times as large as a pivot, another coefficient of its unknown makes it small.
const LARGE: i64 = 1000;

/// Equations that are being solved.
pub(super) struct System<'g> {
    pub graph: &'g mut Graph,
    pub rows: Vec<Equation>,
    /// The coefficients as they were written.
    written: Vec<Vec<Id>>,
    unknowns: usize,
    /// The rows that nothing is solved for yet.
    left: Vec<usize>,
    /// Whether sums of squares are eliminated, and what that made is among `written`.
    is_reduced: bool,
    steps: Vec<Step>,
    pivots: Vec<(usize, Id)>,
}

/// A row that is solved for an unknown, and one over its coefficient.
struct Step {
    row: usize,
    column: usize,
    inverse: Id,
}

impl Graph {
    pub fn solve(&mut self, rows: Vec<Equation>, unknowns: usize) -> Elimination {
        let mut system = System {
            graph: self,
            written: rows.iter().map(|row| row.coefficients.clone()).collect(),
            left: (0..rows.len()).collect(),
            rows,
            unknowns,
            is_reduced: false,
            steps: Vec::new(),
            pivots: Vec::new(),
        };
        loop {
            system.reduce_sizes();
            let Some((kind, row, column)) = system.next_pivot() else {
                break;
            };
            if kind.is_safe() || !system.solve_block() {
                system.eliminate(row, column);
            }
        }
        system.finish()
    }
}

impl System<'_> {
    /// Keeps what the elimination of sums of squares has made, once none is left.
    fn reduce_sizes(&mut self) {
        let open: Vec<usize> = self.open().collect();
        let is_square = |row: &usize| {
            let sizes = &self.rows[*row].sizes;
            open.iter()
                .any(|column| matches!(sizes[*column], Size::Squares))
        };
        if self.is_reduced || self.left.iter().any(is_square) {
            return;
        }
        self.is_reduced = true;
        for row in &self.left {
            for column in &open {
                if matches!(self.rows[*row].sizes[*column], Size::Reduced) {
                    self.written[*row][*column] = self.rows[*row].coefficients[*column];
                }
            }
        }
    }

    /// The best coefficient that does not vanish.
    fn next_pivot(&self) -> Option<(Kind, usize, usize)> {
        let open = self.open();
        let candidates = open.flat_map(|column| self.left.iter().map(move |row| (*row, column)));
        let there = candidates.filter(|(row, column)| self.is_there(*row, *column));
        let best = there.min_by_key(|&(row, column)| {
            let sample = &self.rows[row].sample;
            let others = sample.iter().filter(|entry| !entry.is_zero());
            let kind = self.kind(row, column);
            (
                sample[column].may_vanish(),
                kind,
                others.count(),
                row,
                column,
            )
        });
        best.map(|(row, column)| (self.kind(row, column), row, column))
    }

    fn kind(&self, row: usize, column: usize) -> Kind {
        let graph = &self.graph;
        let coefficient = self.rows[row].coefficients[column];
        let is_early = graph.is_early(coefficient);
        match (graph.as_number(coefficient), self.rows[row].sizes[column]) {
            (_, Size::Reduced) if self.is_reduced => Kind::Squares,
            (_, Size::Beside | Size::Reduced) => Kind::Unsafe,
            (Some(number), _) if self.is_small(number, row, column) => Kind::Unsafe,
            (Some(number), _) if number.abs().is_one() => Kind::One,
            (Some(_), _) => Kind::Number,
            (None, Size::Squares) if is_early => Kind::EarlySquares,
            (None, Size::Squares) => Kind::Squares,
            _ => Kind::Unsafe,
        }
    }

    /// Whether a coefficient is small beside others of its unknown; what is no number counts as one.
    fn is_small(&self, number: &Number, row: usize, column: usize) -> bool {
        let others = self.left.iter().filter(|other| **other != row);
        let mut others = others.map(|other| self.rows[*other].coefficients[column]);
        let bound = number.abs() * Number::integer(LARGE);
        others.any(|other| match self.graph.as_number(other) {
            Some(other) => bound < other.abs(),
            None => bound < Number::one(),
        })
    }

    /// The rows that nothing is solved for yet.
    pub(super) fn left(&self) -> &[usize] {
        &self.left
    }

    /// The unknowns that nothing gives yet.
    pub(super) fn open(&self) -> impl Iterator<Item = usize> {
        let is_open = |column: &usize| self.steps.iter().all(|step| step.column != *column);
        (0..self.unknowns).filter(is_open)
    }

    pub(super) fn is_there(&self, row: usize, column: usize) -> bool {
        !self.rows[row].sample[column].is_zero()
    }

    /// Solves a row for an unknown, which drops out of the others.
    pub(super) fn eliminate(&mut self, row: usize, column: usize) {
        let divisor = self.rows[row].coefficients[column];
        let divisor = match self.rows[row].active {
            Some(active) => {
                let (zero, one) = (self.graph.zero(), self.graph.one());
                self.rows[row].right = self.graph.select(active, self.rows[row].right, zero);
                self.graph.select(active, divisor, one)
            }
            None => divisor,
        };
        let divisor = self.graph.quantity(divisor);
        let size = match self.rows[row].sizes[column] {
            Size::Squares | Size::Reduced => self.written[row][column],
            Size::Product(size) => size,
            Size::Terms | Size::Beside => {
                self.graph.largest_term(self.rows[row].coefficients[column])
            }
        };
        let inverse = self.graph.pivot(divisor, size);
        self.give(row, column, inverse);
        for other in self.left.clone() {
            self.reduce((row, column), other, inverse);
        }
    }

    /// This row gives this unknown, by one over its coefficient.
    pub(super) fn give(&mut self, row: usize, column: usize, inverse: Id) {
        self.left.retain(|other| *other != row);
        let is_new = self.pivots.iter().all(|(_, known)| *known != inverse);
        if is_new && matches!(self.graph.node(inverse), Node::Pivot(..)) {
            self.pivots.push((column, inverse));
        }
        self.steps.push(Step {
            row,
            column,
            inverse,
        });
    }

    /// Takes a multiple of the row of a pivot from another, so that its unknown drops out.
    fn reduce(&mut self, (row, column): (usize, usize), other: usize, inverse: Id) {
        let (graph, rows) = (&mut *self.graph, &mut self.rows);
        if rows[other].sample[column].is_zero() {
            rows[other].coefficients[column] = graph.zero();
            return;
        }
        let factor = graph.multiply(rows[other].coefficients[column], inverse);
        let ratio = rows[other].sample[column].over(&rows[row].sample[column]);
        for index in 0..rows[other].coefficients.len() {
            let sample = rows[other].sample[index].minus(&ratio.times(&rows[row].sample[index]));
            let vanishes = sample.is_zero() || index == column;
            rows[other].coefficients[index] = if vanishes {
                graph.zero()
            } else {
                let change = graph.multiply(factor, rows[row].coefficients[index]);
                graph.subtract(rows[other].coefficients[index], change)
            };
            rows[other].sample[index] = if vanishes { sample.nothing() } else { sample };
        }
        let change = if graph.is_early(factor) {
            graph.distribute(factor, rows[row].right)
        } else {
            graph.multiply(factor, rows[row].right)
        };
        rows[other].right = graph.subtract(rows[other].right, change);
    }

    /// The values, each after those that it is made of.
    fn finish(mut self) -> Elimination {
        let zero = self.graph.zero();
        let mut values = vec![zero; self.unknowns];
        let open: Vec<usize> = self.open().collect();
        // what an undetermined unknown changes in those that are solved for
        let mut changes = vec![vec![zero; self.unknowns]; open.len()];
        for (change, column) in changes.iter_mut().zip(&open) {
            change[*column] = self.graph.one();
        }
        for step in self.order() {
            let step = &self.steps[step];
            let row = &self.rows[step.row];
            let of_others = |graph: &mut Graph, values: &[Id], right: Id| {
                let others = (0..values.len()).filter(|other| *other != step.column);
                others.fold(right, |rest, other| {
                    let known = graph.multiply(row.coefficients[other], values[other]);
                    graph.subtract(rest, known)
                })
            };
            let rest = of_others(self.graph, &values, row.right);
            let value = if self.graph.is_early(step.inverse) {
                self.graph.distribute(step.inverse, rest)
            } else {
                self.graph.multiply(step.inverse, rest)
            };
            values[step.column] = self.graph.quantity(value);
            for change in &mut changes {
                let rest = of_others(self.graph, change, zero);
                change[step.column] = self.graph.multiply(step.inverse, rest);
            }
        }
        let together = open
            .iter()
            .map(|column| self.together(*column, &open, &changes));
        Elimination {
            undetermined: together.collect(),
            values,
            pivots: self.pivots,
            spare: self
                .left
                .iter()
                .map(|row| (*row, self.rows[*row].right))
                .collect(),
        }
    }

    /// The steps, each after those whose unknowns it reads, else as they were taken.
    fn order(&self) -> Vec<usize> {
        let reads = |step: &usize, other: &usize| {
            let coefficients = &self.rows[self.steps[*step].row].coefficients;
            step != other && !self.graph.is_zero(coefficients[self.steps[*other].column])
        };
        let mut left: Vec<usize> = (0..self.steps.len()).collect();
        let mut order = Vec::new();
        let is_next = |left: &Vec<usize>| {
            let waits = |step: &usize| left.iter().any(|other| reads(step, other));
            left.iter().position(|step| !waits(step))
        };
        while let Some(place) = is_next(&left) {
            order.push(left.remove(place));
        }
        order
    }

    /// `u_c - sum of (du_c / du_j) u_j`, of the first unknown c that this one changes.
    fn together(&mut self, column: usize, open: &[usize], changes: &[Vec<Id>]) -> Undetermined {
        let own = open.iter().position(|known| *known == column);
        let is_changed = |of: &usize| {
            let change = own.map(|own| changes[own][*of]);
            !open.contains(of) && change.is_some_and(|change| !self.graph.vanishes(change))
        };
        let others: Vec<usize> = (0..self.unknowns).filter(is_changed).collect();
        let one = self.graph.one();
        let Some(of) = others.first().copied() else {
            let sum = vec![(column, one)];
            return Undetermined {
                column,
                others,
                sum,
            };
        };
        let mut sum = vec![(of, one)];
        for (column, change) in open.iter().zip(changes) {
            if !self.graph.vanishes(change[of]) {
                sum.push((*column, self.graph.negate(change[of])));
            }
        }
        sum.sort_unstable_by_key(|(column, _)| *column);
        Undetermined {
            column,
            others,
            sum,
        }
    }
}
