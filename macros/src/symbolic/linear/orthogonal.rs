//! Equations whose columns are made orthogonal, one after another, and the right sides with them
//! (modified Gram-Schmidt process; A. Bjoerck, "Solving linear least squares problems by
//! Gram-Schmidt orthogonalization", BIT 7, 1967).
//!
//! ```text
//! A = Q R,  q_i . q_j = 0:    R x = y,  y_i = q_i . b / q_i . q_i,  b less y_i q_i for the next
//! ```
//!
//! No coefficient is divided by, only squared lengths of columns. These are positive wherever the
//! equations are regular, so nothing has to be known about the coefficients. A determinant of this
//! many equations would lose digits in its products. In the scalar product, each equation is
//! divided by the length of its coefficients, because equations have different units.
//!
//! The remainder of a column is nothing but rounding error if it is no longer than the rounding
//! error of its parts. The result is that of a matrix whose columns are rounded (Bjoerck, same
//! paper). So the parts are the column itself, and the multiples of the earlier columns that come
//! closest to it:
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
pub(super) struct Entry(pub Id, pub Sample);

impl Entry {
    pub(super) fn nothing(graph: &Graph, sample: &Sample) -> Self {
        Self(graph.zero(), sample.nothing())
    }

    /// `a - factor * b`
    pub(super) fn less(&self, graph: &mut Graph, factor: &Self, b: &Self) -> Self {
        let sample = self.1.minus(&factor.1.times(&b.1));
        if sample.is_zero() {
            return Self::nothing(graph, &sample);
        }
        let part = graph.multiply(factor.0, b.0);
        let value = graph.subtract(self.0, part);
        Self(graph.quantity(value), sample)
    }
}

/// Equations in triangular form: `x_k + sum of factors[k][j] x_j = sides[k]`, where j comes after
/// k.
#[derive(Default)]
pub(super) struct Triangle {
    pub factors: Vec<Vec<Entry>>,
    pub sides: Vec<Vec<Id>>,
    /// The guarded reciprocals of the lengths of columns, unless these are numbers.
    pub inverses: Vec<Option<Id>>,
}

impl Triangle {
    /// `|a_k| + sum of |x_j| |a_j|` of column k, the one to be added next.
    fn parts(&self, graph: &mut Graph, lengths: &[Id], k: usize) -> Id {
        let mut parts = vec![lengths[k]];
        for (Entry(multiple, _), length) in self.solve(graph, k).into_iter().zip(lengths) {
            let multiple = graph.apply(Function::Abs, &[multiple]);
            parts.push(graph.multiply(multiple, *length));
        }
        let parts = graph.sum(&parts);
        graph.quantity(parts)
    }

    /// The multiples of the columns so far that come closest to a later column.
    pub(super) fn solve(&self, graph: &mut Graph, column: usize) -> Vec<Entry> {
        let factors = self.factors.iter().map(|factors| factors[column].clone());
        let mut values: Vec<Entry> = factors.collect();
        for k in (0..values.len()).rev() {
            for j in k + 1..values.len() {
                values[k] = values[k].less(graph, &self.factors[k][j], &values[j]);
            }
        }
        values
    }
}

impl System<'_> {
    /// The first `count` vectors are the columns.
    pub(super) fn triangle(
        &mut self,
        mut vectors: Vec<Vec<Entry>>,
        count: usize,
        mut sides: Vec<Vec<Id>>,
    ) -> Option<Triangle> {
        let weights = self.weights(&vectors[..count])?;
        let lengths = self.lengths(&weights, &vectors[..count]);
        let mut triangle = Triangle::default();
        for k in 0..count {
            let own = vectors[k].clone();
            let square = self.dot(&weights, &own, &own);
            if !square.1.is_nonzero_where_tried() {
                return None;
            }
            let (inverse_square, inverse) = if self.graph.as_number(square.0).is_some() {
                let one = self.graph.one();
                (self.graph.divide(one, square.0), None)
            } else {
                let length = self.graph.apply(Function::Sqrt, &[square.0]);
                let parts = triangle.parts(self.graph, &lengths, k);
                let inverse = self.graph.checked_reciprocal(length, parts);
                (self.graph.square(inverse), Some(inverse))
            };
            let weighted = self.weighted(&weights, &own, inverse_square);
            let mut factors = vec![Entry::nothing(self.graph, &square.1); vectors.len()];
            for (other, vector) in vectors.iter_mut().enumerate().skip(k + 1) {
                factors[other] = self.make_orthogonal((&weighted, &own), vector, &square.1);
            }
            let sides = sides.iter_mut();
            let along = sides.map(|side| self.project((&weighted, &own), side));
            triangle.sides.push(along.collect());
            triangle.factors.push(factors);
            triangle.inverses.push(inverse);
        }
        Some(triangle)
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
            let unit = sum.1.is_nonzero_where_tried().then(|| sum.1.over(&sum.1))?;
            let weight = self.graph.divide(one, sum.0);
            Some(Entry(self.graph.quantity(weight), unit.over(&sum.1)))
        })
        .collect()
    }

    /// `sum of w a b`
    fn dot(&mut self, weights: &[Entry], a: &[Entry], b: &[Entry]) -> Entry {
        let mut sum = Entry::nothing(self.graph, &weights[0].1);
        for (weight, (a, b)) in weights.iter().zip(a.iter().zip(b)) {
            let product = self.graph.multiply(a.0, b.0);
            let product = self.graph.multiply(weight.0, product);
            sum.0 = self.graph.add(sum.0, product);
            sum.1 = sum.1.plus(&weight.1.times(&a.1.times(&b.1)));
        }
        sum.0 = self.graph.quantity(sum.0);
        sum
    }

    /// `w q / q . q`, by `1 / q . q`.
    fn weighted(&mut self, weights: &[Entry], own: &[Entry], inverse_square: Id) -> Vec<Entry> {
        let square = self.graph.quantity(inverse_square);
        let pairs = weights.iter().zip(own);
        pairs
            .map(|(weight, own)| {
                let part = self.graph.multiply(weight.0, own.0);
                let part = self.graph.multiply(square, part);
                Entry(self.graph.quantity(part), weight.1.times(&own.1))
            })
            .collect()
    }

    /// Subtracts from a vector its part along another one, and returns the factor of that part.
    fn make_orthogonal(
        &mut self,
        (weighted, own): (&[Entry], &[Entry]),
        vector: &mut [Entry],
        square: &Sample,
    ) -> Entry {
        let mut factor = Entry::nothing(self.graph, square);
        for (weighted, entry) in weighted.iter().zip(&*vector) {
            let part = self.graph.multiply(weighted.0, entry.0);
            factor.0 = self.graph.add(factor.0, part);
            factor.1 = factor.1.plus(&weighted.1.times(&entry.1));
        }
        if factor.1.is_zero() {
            return Entry::nothing(self.graph, square);
        }
        factor = Entry(self.graph.quantity(factor.0), factor.1.over(square));
        for (own, entry) in own.iter().zip(vector) {
            *entry = entry.less(self.graph, &factor, own);
        }
        factor
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
