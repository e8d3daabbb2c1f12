//! Linear equations with expressions as coefficients, solved by elimination.
//!
//! Zeros are proved: every row carries the values of its coefficients at one random state, on each
//! branch, and these are eliminated along with it. A pivot vanishes on no branch. Ones are
//! preferred to other numbers, and numbers to expressions that are positive by their structure;
//! among these, early ones come first. A division that depends on the configuration is guarded
//! ([`Graph::pivot`]). It may be that all remaining coefficients vanish in some state, or for some
//! parameters, although the equations are regular there; then no pivot is chosen: see
//! [`super::determinant`].
//!
//! If an equation is trivial on some branch, the unknown that it is solved for is zero there.

use crate::symbolic::graph::Graph;
use crate::symbolic::number::Number;

use super::sizes::Size;
use super::system::{Elimination, Equation, System};

/// Kinds of pivots, best first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    One,
    Number,
    EarlySquares,
    Squares,
    /// It may vanish, but not where others do, such as the slopes of closed loops.
    Masses,
    /// It may vanish in some state or for some parameters, or is small compared with others.
    Unsafe,
}

impl Kind {
    /// Whether it is large in all states, or must be used before any unsafe pivot.
    fn is_safe(self) -> bool {
        self <= Self::Masses
    }
}

/// A coefficient is small if another coefficient of the same unknown is this many times as large.
const LARGE: i64 = 1000;

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
        system.values()
    }
}

impl System<'_> {
    /// Once no sums of squares are left, records the coefficients that their elimination has
    /// produced.
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

    /// The best coefficient that is not proved to be zero.
    fn next_pivot(&self) -> Option<(Kind, usize, usize)> {
        let open = self.open();
        let candidates = open.flat_map(|column| self.left.iter().map(move |row| (*row, column)));
        let there = candidates.filter(|(row, column)| self.is_there(*row, *column));
        let best = there.min_by_key(|&(row, column)| {
            let sample = &self.rows[row].sample;
            let others = sample.iter().filter(|entry| !entry.is_zero());
            let kind = self.kind(row, column);
            (
                !sample[column].is_nonzero_where_tried(),
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
            (_, Size::Masses) => Kind::Masses,
            _ => Kind::Unsafe,
        }
    }

    /// Whether a coefficient is small compared with the others of its unknown. Those that are not
    /// numbers count as one.
    fn is_small(&self, number: &Number, row: usize, column: usize) -> bool {
        let others = self.left.iter().filter(|other| **other != row);
        let mut others = others.map(|other| self.rows[*other].coefficients[column]);
        let bound = number.abs() * Number::integer(LARGE);
        others.any(|other| match self.graph.as_number(other) {
            Some(other) => bound < other.abs(),
            None => bound < Number::one(),
        })
    }
}
