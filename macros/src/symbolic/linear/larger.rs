//! Three or more equations solved together: with orthogonal columns, or with the inverse of
//! coefficients that are known early.

use crate::symbolic::graph::Id;

use super::orthogonal::{Entry, Triangle};
use super::system::System;

impl System<'_> {
    /// Solves these rows for these columns, unless the columns may be dependent on some branch. The
    /// unknowns `solved` are solved for already, but still on the left side.
    pub(super) fn solve_larger(
        &mut self,
        rows: &[usize],
        columns: &[usize],
        solved: &[usize],
    ) -> bool {
        let vector = |column: &usize| {
            let rows = rows.iter().map(|row| {
                let sample = self.rows[*row].sample[*column].clone();
                Entry(self.coefficient(*row, *column), sample)
            });
            rows.collect()
        };
        let vectors: Vec<Vec<Entry>> = columns.iter().map(vector).collect();
        let of = |row: &usize, column: &usize| self.coefficient(*row, *column);
        let sides = solved.iter();
        let mut sides: Vec<Vec<Id>> = sides
            .map(|column| rows.iter().map(|row| of(row, column)).collect())
            .collect();
        sides.push(rows.iter().map(|row| self.rows[*row].right).collect());
        let Some(triangle) = self.triangle_of(&vectors, &sides) else {
            return false;
        };
        for (place, (row, column)) in rows.iter().zip(columns).enumerate() {
            let equation = &mut self.rows[*row];
            equation.coefficients.fill(self.graph.zero());
            let factors = triangle.factors[place].iter().map(|factor| factor.0);
            let factors = columns.iter().copied().zip(factors);
            let sides = triangle.sides[place].iter().copied();
            let sides = solved.iter().copied().zip(sides);
            for (other, coefficient) in factors.chain(sides) {
                equation.coefficients[other] = coefficient;
            }
            equation.right = triangle.sides[place][solved.len()];
            let inverse = triangle.inverses[place];
            self.pivots
                .extend(inverse.map(|inverse| (*column, inverse)));
            let one = self.graph.one();
            self.give(*row, *column, one);
        }
        true
    }

    /// The triangular form. If all coefficients are known early, so is their inverse, and the
    /// triangular form is already solved.
    fn triangle_of(&mut self, vectors: &[Vec<Entry>], sides: &[Vec<Id>]) -> Option<Triangle> {
        let count = vectors.len();
        let mut entries = vectors.iter().flatten();
        if !entries.all(|entry| self.graph.is_early(entry.0)) {
            return self.triangle(vectors.to_vec(), count, sides.to_vec());
        }
        let (inverse, inverses) = self.inverse(vectors)?;
        let sums = (0..count).map(|k| {
            let sums = sides.iter().map(|side| {
                let parts = inverse.iter().zip(side);
                let parts = parts.map(|(of, side)| self.graph.multiply(of[k].0, *side));
                let parts: Vec<Id> = parts.collect();
                self.graph.sum(&parts)
            });
            sums.collect()
        });
        Some(Triangle {
            sides: sums.collect(),
            factors: vec![Vec::new(); count],
            inverses,
        })
    }
}
