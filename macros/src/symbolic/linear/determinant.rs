//! Equations that are solved at once, by Cramer's rule, where no coefficient can be told to be a
//! pivot: only their determinant is divided by.
//!
//! ```text
//! x_j = sum of C_ij b_i / det A       C_ij: cofactors;  det A = sum of a_0j C_0j
//! ```
//!
//! A coefficient that depends on the state, or on parameters, may be zero where the equations are
//! regular; their determinant is not. It is compared with the largest of its products, so that what
//! is nothing but rounding is not divided by.

use std::collections::HashMap;

use crate::symbolic::graph::Id;
use crate::symbolic::number::Function;
use crate::symbolic::zeros::Sample;

use super::eliminate::System;

/// The most equations that are solved at once: beyond it there is more to multiply than elimination
/// has.
const MOST: usize = 4;
/// The same where it is multiplied early.
const MOST_EARLY: usize = 6;

/// A determinant, and its value at the random state.
type Entry = (Id, Sample);

/// The determinants of some rows and columns, by these.
type Minors = HashMap<(Vec<usize>, Vec<usize>), Entry>;

impl System<'_> {
    /// Solves all equations that have a part in what this row says of this unknown, if there are
    /// some, and their determinant vanishes on no branch.
    pub(super) fn is_solved_at_once(&mut self, row: usize, column: usize) -> bool {
        let Some((rows, columns)) = self.block(row, column) else {
            return false;
        };
        let mut known = Minors::new();
        let (determinant, sample) = self.minor(&mut known, &rows, &columns);
        if sample.may_vanish() {
            return false;
        }
        let size = self.size(&rows, &columns);
        let inverse = self.guarded(column, determinant, size);
        let numerators: Vec<Id> = (0..columns.len())
            .map(|place| self.numerator(&mut known, &rows, &columns, place))
            .collect();
        let zero = self.graph.zero();
        for ((row, column), numerator) in rows.into_iter().zip(columns).zip(numerators) {
            self.rows[row].coefficients.fill(zero);
            self.rows[row].right = numerator;
            self.give(row, column, inverse);
        }
        true
    }

    /// The equations around a coefficient, if there are as many as unknowns, and not too many: alone
    /// in its row or its column, it vanishes where their determinant does.
    fn block(&self, row: usize, column: usize) -> Option<(Vec<usize>, Vec<usize>)> {
        let (rows, columns) = self.around(row, column);
        let in_column = rows.iter().filter(|row| self.is_there(**row, column));
        let in_row = columns.iter().filter(|column| self.is_there(row, **column));
        let is_alone = in_column.count() == 1 || in_row.count() == 1;
        let equations = || rows.iter().map(|row| &self.rows[*row]);
        let is_plain = equations().all(|equation| equation.active.is_none());
        let mut coefficients = equations().flat_map(|equation| &equation.coefficients);
        let most = if coefficients.all(|id| self.graph.is_early(*id)) {
            MOST_EARLY
        } else {
            MOST
        };
        let fits = rows.len() == columns.len() && rows.len() <= most;
        (!is_alone && is_plain && fits).then_some((rows, columns))
    }

    /// `sum of C_ij b_i`, of the unknown in the place j.
    fn numerator(
        &mut self,
        known: &mut Minors,
        rows: &[usize],
        columns: &[usize],
        place: usize,
    ) -> Id {
        let mut sum = self.graph.zero();
        for (index, row) in rows.iter().enumerate() {
            let (minor, _) = self.minor(known, &without(rows, index), &without(columns, place));
            let part = self.graph.multiply(minor, self.rows[*row].right);
            sum = if (index + place).is_multiple_of(2) {
                self.graph.add(sum, part)
            } else {
                self.graph.subtract(sum, part)
            };
        }
        sum
    }

    /// The determinant of these rows and columns, along its first row; what is proved to vanish is
    /// left out.
    fn minor(&mut self, known: &mut Minors, rows: &[usize], columns: &[usize]) -> Entry {
        let first = &self.rows[rows[0]];
        if let [column] = *columns {
            return (first.coefficients[column], first.sample[column].clone());
        }
        let place = (rows.to_vec(), columns.to_vec());
        if let Some(entry) = known.get(&place) {
            return entry.clone();
        }
        let mut sum = self.graph.zero();
        let mut sample = first.sample[columns[0]].nothing();
        for (index, column) in columns.iter().enumerate() {
            if !self.is_there(rows[0], *column) {
                continue;
            }
            let (minor, of_minor) = self.minor(known, &rows[1..], &without(columns, index));
            let first = &self.rows[rows[0]];
            let part = self.graph.multiply(first.coefficients[*column], minor);
            let own = first.sample[*column].times(&of_minor);
            (sum, sample) = if index.is_multiple_of(2) {
                (self.graph.add(sum, part), sample.plus(&own))
            } else {
                (self.graph.subtract(sum, part), sample.minus(&own))
            };
        }
        if sample.is_zero() {
            sum = self.graph.zero();
        }
        let entry = (self.graph.quantity(sum), sample);
        known.insert(place, entry.clone());
        entry
    }

    /// The size of the largest product in a determinant.
    fn size(&mut self, rows: &[usize], columns: &[usize]) -> Id {
        let mut largest = self.graph.zero();
        for (index, column) in columns.iter().enumerate() {
            if !self.is_there(rows[0], *column) {
                continue;
            }
            let own = self.rows[rows[0]].coefficients[*column];
            let mut size = self.graph.apply(Function::Abs, &[own]);
            if rows.len() > 1 {
                let rest = self.size(&rows[1..], &without(columns, index));
                size = self.graph.multiply(size, rest);
            }
            largest = self.graph.larger(largest, size);
        }
        largest
    }
}

fn without(places: &[usize], index: usize) -> Vec<usize> {
    let (before, after) = places.split_at(index);
    [before, &after[1..]].concat()
}
