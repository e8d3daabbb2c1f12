//! The inverse of a matrix whose coefficients are known before the state is. Numbers are exact, so
//! any nonzero number can be a divisor; parameters are solved for with orthogonal columns.

use crate::symbolic::graph::Id;

use super::orthogonal::Entry;
use super::system::System;

/// The unknowns for a unit right side in each equation.
type Inverse = Vec<Vec<Entry>>;

impl System<'_> {
    /// The inverse of a matrix given by its columns, and the guarded reciprocals in it. `None` if
    /// the columns may be dependent.
    pub(super) fn inverse(&mut self, columns: &[Vec<Entry>]) -> Option<(Inverse, Vec<Option<Id>>)> {
        let mut entries = columns.iter().flatten();
        if entries.all(|entry| self.graph.as_number(entry.0).is_some()) {
            return Some((self.inverse_of_numbers(columns)?, vec![None; columns.len()]));
        }
        let count = columns.len();
        let units = self.units(columns)?;
        let beside = columns.iter().cloned().chain(units).collect();
        let triangle = self.triangle(beside, count, Vec::new())?;
        let inverse = (count..2 * count).map(|unit| triangle.solve(self.graph, unit));
        Some((inverse.collect(), triangle.inverses))
    }

    /// Gauss-Jordan elimination.
    fn inverse_of_numbers(&mut self, columns: &[Vec<Entry>]) -> Option<Inverse> {
        let count = columns.len();
        let units = self.units(columns)?;
        let row = |row: usize| {
            let all = columns.iter().chain(&units);
            all.map(|column| column[row].clone()).collect()
        };
        let mut rows: Vec<Vec<Entry>> = (0..count).map(row).collect();
        for k in 0..count {
            let pivot = (k..count).find(|row| rows[*row][k].1.is_nonzero_where_tried())?;
            rows.swap(k, pivot);
            let divisor = rows[k][k].clone();
            for entry in &mut rows[k] {
                let value = self.graph.divide(entry.0, divisor.0);
                *entry = Entry(value, entry.1.over(&divisor.1));
            }
            let own = rows[k].clone();
            let others = rows.iter_mut().enumerate();
            for (_, row) in others.filter(|(other, _)| *other != k) {
                let factor = row[k].clone();
                for (entry, own) in row.iter_mut().zip(&own) {
                    *entry = entry.less(self.graph, &factor, own);
                }
            }
        }
        let unit = |unit: usize| rows.iter().map(|row| row[unit].clone()).collect();
        Some((count..2 * count).map(unit).collect())
    }

    /// The columns of the unit matrix.
    fn units(&self, columns: &[Vec<Entry>]) -> Option<Vec<Vec<Entry>>> {
        let mut entries = columns.iter().flatten();
        let Entry(_, sample) = entries.find(|entry| entry.1.is_nonzero_where_tried())?;
        let one = Entry(self.graph.one(), sample.over(sample));
        let nothing = Entry::nothing(self.graph, sample);
        let units = (0..columns.len()).map(|own| {
            let mut unit = vec![nothing.clone(); columns.len()];
            unit[own] = one.clone();
            unit
        });
        Some(units.collect())
    }
}
