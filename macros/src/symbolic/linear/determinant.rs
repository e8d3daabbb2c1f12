//! Equations solved together if no coefficient is a safe pivot. Two are solved by Cramer's rule,
//! which divides only by their determinant.
//!
//! ```text
//! a x + b y = f       x = (d f - b g) / (a d - b c)
//! c x + d y = g       y = (a g - c f) / (a d - b c)
//! ```
//!
//! A coefficient that depends on the state, or on parameters, may be zero although the equations
//! are regular; their determinant cannot. It is compared with the larger of its two products, so a
//! determinant that is nothing but rounding error is not used. Determinants of more equations lose
//! digits: see [`super::larger`].

use crate::symbolic::graph::Id;
use crate::symbolic::number::Function;

use super::system::System;

impl System<'_> {
    /// Solves the smallest set of equations with as many unknowns, if there is one and it is
    /// singular on no branch that is tried.
    pub(super) fn solve_block(&mut self) -> bool {
        let Some((rows, columns)) = self.first_block() else {
            return false;
        };
        let mut equations = rows.iter().map(|row| &self.rows[*row]);
        if equations.any(|equation| equation.active.is_some()) {
            return false;
        }
        // unknowns that are solved for already are still on the left side
        let solved: Vec<usize> = (0..self.rows[rows[0]].coefficients.len())
            .filter(|column| !columns.contains(column))
            .collect();
        match (&rows[..], &columns[..]) {
            ([row], [column]) => {
                let is_regular = self.rows[*row].sample[*column].is_nonzero_where_tried();
                if is_regular {
                    self.eliminate(*row, *column);
                }
                is_regular
            }
            (&[first, second], &[x, y]) => self.solve_pair([first, second], [x, y], &solved),
            _ => self.solve_larger(&rows, &columns, &solved),
        }
    }

    fn solve_pair(&mut self, rows: [usize; 2], columns: [usize; 2], solved: &[usize]) -> bool {
        let samples = rows.map(|row| columns.map(|column| self.rows[row].sample[column].clone()));
        let [[a, b], [c, d]] = &samples;
        let determinant = a.times(d).minus(&b.times(c));
        if !determinant.is_nonzero_where_tried() {
            return false;
        }
        let of = |column: usize| rows.map(|row| self.coefficient(row, column));
        let sides: Vec<[Id; 2]> = solved.iter().map(|column| of(*column)).collect();
        let right = rows.map(|row| self.rows[row].right);
        let [[a, c], [b, d]] = columns.map(of);
        let inverse = self.inverse_of_determinant([[a, b], [c, d]]);
        let [minus_b, minus_c] = [b, c].map(|entry| self.graph.negate(entry));
        let cofactors = [[d, minus_b], [minus_c, a]];
        for ((row, column), factors) in rows.into_iter().zip(columns).zip(cofactors) {
            let left: Vec<Id> = sides.iter().map(|side| self.sum(factors, *side)).collect();
            let right = self.sum(factors, right);
            let equation = &mut self.rows[row];
            equation.coefficients.fill(self.graph.zero());
            for (column, coefficient) in solved.iter().zip(left) {
                equation.coefficients[*column] = coefficient;
            }
            equation.right = right;
            self.give(row, column, inverse);
        }
        true
    }

    fn sum(&mut self, [first, second]: [Id; 2], [f, g]: [Id; 2]) -> Id {
        let (first, second) = (
            self.graph.multiply(first, f),
            self.graph.multiply(second, g),
        );
        self.graph.add(first, second)
    }

    /// `1 / (a d - b c)`, guarded.
    fn inverse_of_determinant(&mut self, [[a, b], [c, d]]: [[Id; 2]; 2]) -> Id {
        let graph = &mut *self.graph;
        let pairs = [(a, d), (b, c)];
        let [first, second] = pairs.map(|(one, other)| graph.multiply(one, other));
        let determinant = graph.subtract(first, second);
        let determinant = graph.quantity(determinant);
        let mut largest = graph.zero();
        for (one, other) in pairs {
            let [one, other] = [one, other].map(|entry| graph.apply(Function::Abs, &[entry]));
            let size = graph.multiply(one, other);
            if !graph.is_zero(size) {
                largest = graph.larger(largest, size);
            }
        }
        let largest = graph.quantity(largest);
        graph.checked_reciprocal(determinant, largest)
    }
}
