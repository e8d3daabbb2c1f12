//! Larger sets of equations solved at once: their columns are made orthogonal, one after another,
//! and the right sides with them (modified Gram-Schmidt process; A. Bjoerck, "Solving linear least
//! squares problems by Gram-Schmidt orthogonalization", BIT 7, 1967).
//!
//! ```text
//! A = Q R,  q_i . q_j = 0:    R x = y,  y_i = q_i . b / q_i . q_i,  b less y_i q_i for the next
//! ```
//!
//! No coefficient is divided by, only lengths of columns, which are positive wherever the equations
//! are regular: so nothing has to be known about the coefficients. A determinant of this many
//! equations would lose digits in its products. In the scalar product, each equation is divided by
//! the length of its coefficients, as equations have different units.
//!
//! What is left of a column is rounding if it is no longer than the rounding of its parts. The
//! result is that of a matrix whose columns are rounded (Bjoerck, same paper), so the parts are the
//! multiples of the earlier columns that come closest to it, and the column itself:
//!
//! ```text
//! |a_k| + sum of |x_j| |a_j|        a_k - sum of x_j a_j = q_k
//! ```

use crate::symbolic::graph::{Graph, Id};
use crate::symbolic::number::Function;
use crate::symbolic::zeros::Sample;

use super::system::System;

/// An expression, and its value at the random state.
#[derive(Clone)]
struct Entry(Id, Sample);

/// The columns that are orthogonal already.
#[derive(Default)]
struct Before {
    /// Of each, the factors by which it was subtracted from later columns.
    factors: Vec<Vec<Id>>,
}

impl Before {
    /// `|a_k| + sum of |x_j| |a_j|` of column k.
    fn parts(&self, graph: &mut Graph, lengths: &[Id], k: usize) -> Id {
        let mut multiples = vec![graph.zero(); k];
        let mut parts = vec![lengths[k]];
        for j in (0..k).rev() {
            let mut multiple = self.factors[j][k];
            for i in j + 1..k {
                let less = graph.multiply(self.factors[j][i], multiples[i]);
                multiple = graph.subtract(multiple, less);
            }
            multiples[j] = graph.quantity(multiple);
            let size = graph.apply(Function::Abs, &[multiples[j]]);
            parts.push(graph.multiply(size, lengths[j]));
        }
        let parts = graph.sum(&parts);
        graph.quantity(parts)
    }
}

impl System<'_> {
    /// Solves these rows for these columns, unless they may be dependent on some branch. `solved`
    /// are unknowns that are solved for already and still on the left.
    pub(super) fn solve_orthogonal(
        &mut self,
        rows: &[usize],
        columns: &[usize],
        solved: &[usize],
    ) -> bool {
        let entry = |row: &usize, column: usize| {
            let row = &self.rows[*row];
            Entry(row.coefficients[column], row.sample[column].clone())
        };
        let vector = |column: &usize| rows.iter().map(|row| entry(row, *column)).collect();
        let mut vectors: Vec<Vec<Entry>> = columns.iter().map(vector).collect();
        let mut sides: Vec<Vec<Id>> = solved
            .iter()
            .map(|column| rows.iter().map(|row| entry(row, *column).0).collect())
            .collect();
        sides.push(rows.iter().map(|row| self.rows[*row].right).collect());
        let Some(weights) = self.weights(&vectors) else {
            return false;
        };
        let mut before = Before::default();
        let zero = self.graph.zero();
        let lengths = self.lengths(&weights, &vectors);
        let mut found = Vec::new();
        for (place, column) in columns.iter().enumerate() {
            let own = vectors[place].clone();
            let square = self.dot(&weights, &own, &own);
            if square.1.may_vanish() {
                return false;
            }
            let length = self.graph.apply(Function::Sqrt, &[square.0]);
            let parts = before.parts(self.graph, &lengths, place);
            let inverse = self.graph.checked_reciprocal(length, parts);
            let weighted = self.weighted(&weights, &own, inverse);
            let mut coefficients = vec![zero; self.rows[rows[place]].coefficients.len()];
            let mut factors = vec![zero; columns.len()];
            for (other, vector) in vectors.iter_mut().enumerate().skip(place + 1) {
                factors[other] = self.make_orthogonal((&weighted, &own), vector, &square.1);
                coefficients[columns[other]] = factors[other];
            }
            before.factors.push(factors);
            let mut along = sides
                .iter_mut()
                .map(|side| self.project((&weighted, &own), side))
                .collect::<Vec<Id>>();
            let right = along.pop().unwrap_or(zero);
            for (other, along) in solved.iter().zip(along) {
                coefficients[*other] = along;
            }
            found.push((*column, inverse, coefficients, right));
        }
        for (row, (column, inverse, coefficients, right)) in rows.iter().zip(found) {
            self.rows[*row].coefficients = coefficients;
            self.rows[*row].right = right;
            self.pivots.push((column, inverse));
            let one = self.graph.one();
            self.give(*row, column, one);
        }
        true
    }

    /// `|a|` of each column.
    fn lengths(&mut self, weights: &[Entry], vectors: &[Vec<Entry>]) -> Vec<Id> {
        let lengths = vectors.iter().map(|vector| {
            let square = self.dot(weights, vector, vector).0;
            self.graph.apply(Function::Sqrt, &[square])
        });
        lengths.collect()
    }

    /// `1 / |a|^2` of each row; none if a row may be zero.
    fn weights(&mut self, vectors: &[Vec<Entry>]) -> Option<Vec<Entry>> {
        let one = self.graph.one();
        let rows = 0..vectors.len();
        rows.map(|row| {
            let mut entries = vectors.iter().map(|vector| &vector[row]);
            let first = entries.next()?;
            let mut sum = Entry(self.graph.square(first.0), first.1.times(&first.1));
            for Entry(value, sample) in entries {
                let square = self.graph.square(*value);
                sum.0 = self.graph.add(sum.0, square);
                sum.1 = sum.1.plus(&sample.times(sample));
            }
            let unit = (!sum.1.may_vanish()).then(|| sum.1.over(&sum.1))?;
            let weight = self.graph.divide(one, sum.0);
            Some(Entry(self.graph.quantity(weight), unit.over(&sum.1)))
        })
        .collect()
    }

    /// `sum of w a b`
    fn dot(&mut self, weights: &[Entry], a: &[Entry], b: &[Entry]) -> Entry {
        let mut sum = Entry(self.graph.zero(), weights[0].1.nothing());
        for (weight, (a, b)) in weights.iter().zip(a.iter().zip(b)) {
            let product = self.graph.multiply(a.0, b.0);
            let product = self.graph.multiply(weight.0, product);
            sum.0 = self.graph.add(sum.0, product);
            sum.1 = sum.1.plus(&weight.1.times(&a.1.times(&b.1)));
        }
        sum.0 = self.graph.quantity(sum.0);
        sum
    }

    /// `w q / q . q`, with the guarded inverse of the length of q.
    fn weighted(&mut self, weights: &[Entry], own: &[Entry], inverse: Id) -> Vec<Entry> {
        let square = self.graph.square(inverse);
        let square = self.graph.quantity(square);
        let pairs = weights.iter().zip(own);
        pairs
            .map(|(weight, own)| {
                let part = self.graph.multiply(weight.0, own.0);
                let part = self.graph.multiply(square, part);
                Entry(self.graph.quantity(part), weight.1.times(&own.1))
            })
            .collect()
    }

    /// Subtracts from a vector its part along another one, and gives the factor of that.
    fn make_orthogonal(
        &mut self,
        (weighted, own): (&[Entry], &[Entry]),
        vector: &mut [Entry],
        square: &Sample,
    ) -> Id {
        let mut factor = Entry(self.graph.zero(), square.nothing());
        for (weighted, entry) in weighted.iter().zip(&*vector) {
            let part = self.graph.multiply(weighted.0, entry.0);
            factor.0 = self.graph.add(factor.0, part);
            factor.1 = factor.1.plus(&weighted.1.times(&entry.1));
        }
        if factor.1.is_zero() {
            return self.graph.zero();
        }
        factor = Entry(self.graph.quantity(factor.0), factor.1.over(square));
        for (own, entry) in own.iter().zip(vector) {
            let sample = entry.1.minus(&factor.1.times(&own.1));
            let part = self.graph.multiply(factor.0, own.0);
            let value = self.graph.subtract(entry.0, part);
            *entry = if sample.is_zero() {
                Entry(self.graph.zero(), sample.nothing())
            } else {
                Entry(self.graph.quantity(value), sample)
            };
        }
        factor.0
    }

    /// The same for a right side.
    fn project(&mut self, (weighted, own): (&[Entry], &[Entry]), side: &mut [Id]) -> Id {
        let mut factor = self.graph.zero();
        for (weighted, value) in weighted.iter().zip(&*side) {
            let part = self.graph.multiply(weighted.0, *value);
            factor = self.graph.add(factor, part);
        }
        factor = self.graph.quantity(factor);
        for (own, value) in own.iter().zip(side) {
            let part = self.graph.multiply(factor, own.0);
            let rest = self.graph.subtract(*value, part);
            *value = self.graph.quantity(rest);
        }
        factor
    }
}
