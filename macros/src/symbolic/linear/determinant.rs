//! Equations solved at once, by Cramer's rule, if no coefficient is a safe
//! pivot: only their determinant is divided by.
//!
//! ```text
//! x_j = sum of C_ij b_i / det A       C_ij: cofactors;  det A = sum of a_0j C_0j
//! ```
//!
//! A coefficient that depends on the state, or on parameters, may be zero although the equations
//! are regular; their determinant is not. It is compared with the largest of its products, so a
//! determinant that is nothing but rounding is not used.

use std::collections::HashMap;

use crate::symbolic::graph::Id;
use crate::symbolic::number::Function;
use crate::symbolic::zeros::Sample;

use super::system::{Equation, System};

/// The limit of equations solved at once: beyond it, elimination multiplies less.
const MOST: usize = 6;

/// A determinant, and its value at the random state.
type Entry = (Id, Sample);

/// The determinants of some rows and columns, by these.
type Minors = HashMap<(Vec<usize>, Vec<usize>), Entry>;

/// The sizes of determinants, in the same way.
type Sizes = HashMap<(Vec<usize>, Vec<usize>), Id>;

impl System<'_> {
    /// Solves the smallest set of equations that involves equally many unknowns, if there is
    /// one, and its determinant vanishes on no branch.
    pub(super) fn solve_block(&mut self) -> bool {
        let Some((rows, columns)) = self.first_block() else {
            return false;
        };
        let mut equations = rows.iter().map(|row| &self.rows[*row]);
        if rows.len() > MOST || equations.any(|equation| equation.active.is_some()) {
            return false;
        }
        let mut known = Minors::new();
        let (determinant, sample) = self.minor(&mut known, &rows, &columns);
        if sample.may_vanish() {
            return false;
        }
        if let ([row], [column]) = (&rows[..], &columns[..]) {
            self.eliminate(*row, *column);
            return true;
        }
        let size = self.size(&mut Sizes::new(), &rows, &columns);
        let inverse = self.graph.checked_reciprocal(determinant, size);
        // unknowns that are already solved for are still on the left
        let solved: Vec<usize> = (0..self.rows[rows[0]].coefficients.len())
            .filter(|column| !columns.contains(column))
            .collect();
        let mut sides = Vec::new();
        for place in 0..columns.len() {
            let cofactors = self.cofactors(&mut known, &rows, &columns, place);
            let right = self.combined(&cofactors, |row| row.right);
            let left: Vec<Id> = solved
                .iter()
                .map(|column| self.combined(&cofactors, |row| row.coefficients[*column]))
                .collect();
            sides.push((right, left));
        }
        for ((row, column), (right, left)) in rows.into_iter().zip(columns).zip(sides) {
            let zero = self.graph.zero();
            self.rows[row].coefficients.fill(zero);
            for (column, coefficient) in solved.iter().zip(left) {
                self.rows[row].coefficients[*column] = coefficient;
            }
            self.rows[row].right = right;
            self.give(row, column, inverse);
        }
        true
    }

    /// The factors of the rows that leave only the unknown at this place.
    fn cofactors(
        &mut self,
        known: &mut Minors,
        rows: &[usize],
        columns: &[usize],
        place: usize,
    ) -> Vec<(usize, Id)> {
        let mut cofactors = Vec::new();
        for (index, row) in rows.iter().enumerate() {
            let (minor, _) = self.minor(known, &without(rows, index), &without(columns, place));
            let is_positive = (index + place).is_multiple_of(2);
            let cofactor = if is_positive {
                minor
            } else {
                self.graph.negate(minor)
            };
            cofactors.push((*row, cofactor));
        }
        cofactors
    }

    /// `sum of C_i b_i`
    fn combined(&mut self, cofactors: &[(usize, Id)], of: impl Fn(&Equation) -> Id) -> Id {
        let mut sum = self.graph.zero();
        for (row, cofactor) in cofactors {
            let part = self.graph.multiply(*cofactor, of(&self.rows[*row]));
            sum = self.graph.add(sum, part);
        }
        sum
    }

    /// The determinant of these rows and columns, expanded along its first row; terms proved to
    /// vanish are left out.
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
    fn size(&mut self, known: &mut Sizes, rows: &[usize], columns: &[usize]) -> Id {
        let place = (rows.to_vec(), columns.to_vec());
        if let Some(size) = known.get(&place) {
            return *size;
        }
        let mut largest = self.graph.zero();
        for (index, column) in columns.iter().enumerate() {
            if !self.is_there(rows[0], *column) {
                continue;
            }
            let own = self.rows[rows[0]].coefficients[*column];
            let mut size = self.graph.apply(Function::Abs, &[own]);
            if rows.len() > 1 {
                let rest = self.size(known, &rows[1..], &without(columns, index));
                size = self.graph.multiply(size, rest);
            }
            largest = self.graph.larger(largest, size);
        }
        if rows.len() > 1 {
            largest = self.graph.quantity(largest);
        }
        known.insert(place, largest);
        largest
    }
}

fn without(places: &[usize], index: usize) -> Vec<usize> {
    let (before, after) = places.split_at(index);
    [before, &after[1..]].concat()
}
