//! Linear equations with coefficients that are known early, solved exactly.
//!
//! Gauss-Jordan elimination by structure: pivots are ones before numbers before parameters, and
//! what is zero for all parameters is proved to be so.

use crate::symbolic::graph::{Graph, Id, Stage};

/// `sum of coefficients * unknowns = right`
pub struct Equation {
    pub coefficients: Vec<Id>,
    pub right: Id,
}

/// What equations say of their unknowns.
pub struct Solution {
    /// The value of each unknown; that of an undetermined one is arbitrary.
    pub values: Vec<Id>,
    /// For each unknown that is not determined, the unknowns that are only determined together
    /// with it, and with which factors: itself with the factor one among them.
    pub undetermined: Vec<Vec<(usize, Id)>>,
    /// Equations without unknowns, by their index, whose right side is not zero.
    pub unbalanced: Vec<usize>,
}

impl Graph {
    pub fn solve(&mut self, mut equations: Vec<Equation>, unknowns: usize) -> Solution {
        let mut pivots: Vec<Option<usize>> = vec![None; unknowns];
        let mut free_rows: Vec<usize> = (0..equations.len()).collect();
        while let Some((row, column)) = self.best_pivot(&equations, &free_rows, &pivots) {
            free_rows.retain(|free| *free != row);
            pivots[column] = Some(row);
            let one = self.one();
            let scale = self.divide(one, equations[row].coefficients[column]);
            self.scale_equation(&mut equations[row], scale);
            for other in (0..equations.len()).filter(|other| *other != row) {
                let factor = equations[other].coefficients[column];
                if !self.is_zero(factor) {
                    let (pivot, reduced) = pair(&mut equations, row, other);
                    self.eliminate(reduced, pivot, factor);
                }
            }
        }
        let undetermined = (0..unknowns).filter(|column| pivots[*column].is_none());
        let together = undetermined.map(|column| {
            let mut together = vec![(column, self.one())];
            for (other, pivot) in pivots.iter().enumerate() {
                let shared = pivot.map(|row| equations[row].coefficients[column]);
                together.extend(
                    shared
                        .filter(|id| !self.vanishes(*id))
                        .map(|id| (other, id)),
                );
            }
            together.sort_unstable_by_key(|(unknown, _)| *unknown);
            together
        });
        let undetermined = together.collect();
        let unbalanced = free_rows
            .into_iter()
            .filter(|row| !self.is_zero(equations[*row].right))
            .collect();
        let zero = self.zero();
        let values = pivots
            .iter()
            .map(|pivot| pivot.map_or(zero, |row| equations[row].right))
            .collect();
        Solution {
            values,
            undetermined,
            unbalanced,
        }
    }

    fn scale_equation(&mut self, equation: &mut Equation, factor: Id) {
        for coefficient in &mut equation.coefficients {
            *coefficient = self.multiply(factor, *coefficient);
        }
        equation.right = self.distribute(factor, equation.right);
    }

    /// `reduced - factor * pivot`
    fn eliminate(&mut self, reduced: &mut Equation, pivot: &Equation, factor: Id) {
        for (coefficient, of_pivot) in reduced.coefficients.iter_mut().zip(&pivot.coefficients) {
            let change = self.multiply(factor, *of_pivot);
            *coefficient = self.subtract(*coefficient, change);
            if self.vanishes(*coefficient) {
                *coefficient = self.zero();
            }
        }
        let change = self.distribute(factor, pivot.right);
        reduced.right = self.subtract(reduced.right, change);
    }

    /// The row and column of the simplest coefficient that is not zero.
    fn best_pivot(
        &mut self,
        equations: &[Equation],
        rows: &[usize],
        pivots: &[Option<usize>],
    ) -> Option<(usize, usize)> {
        let mut best = None;
        for &row in rows {
            for column in (0..pivots.len()).filter(|column| pivots[*column].is_none()) {
                let coefficient = equations[row].coefficients[column];
                if self.vanishes(coefficient) {
                    continue;
                }
                let is_unit = self
                    .as_number(coefficient)
                    .is_some_and(|number| number.abs().is_one());
                let kind = match self.stage(coefficient) {
                    _ if is_unit => 0,
                    Stage::Constant => 1,
                    Stage::Parameter | Stage::State => 2,
                };
                let others = equations[row]
                    .coefficients
                    .iter()
                    .filter(|id| !self.is_zero(**id))
                    .count();
                let rank = (kind, others, row, column);
                if best.is_none_or(|known| rank < known) {
                    best = Some(rank);
                }
            }
        }
        best.map(|(_, _, row, column)| (row, column))
    }
}

/// Two different equations.
fn pair(equations: &mut [Equation], pivot: usize, other: usize) -> (&Equation, &mut Equation) {
    if pivot < other {
        let (left, right) = equations.split_at_mut(other);
        (&left[pivot], &mut right[0])
    } else {
        let (left, right) = equations.split_at_mut(pivot);
        (&right[0], &mut left[other])
    }
}
