//! Balances and constraint rows, as equations for the coordinates first and then the loads.

use crate::mechanics::proofs::samples;
use crate::model::{Labels, Workspace};
use crate::symbolic::{Elimination, Equation, Id, Size};

/// A row, and the effect of its load.
pub struct LoadedRow {
    pub slopes: Vec<Id>,
    pub right: Id,
    /// The effect of a unit of its load along each coordinate.
    pub pushes: Vec<Id>,
    /// The factor of its load in the row itself.
    pub own: Id,
}

/// What guarded reciprocals are, for generated code.
pub const GUARDED: &str =
    "1 over it, or NaN if it is only rounding error: there, constraints are dependent";

/// Names the equations that elimination leaves; `names` are those of the coordinates and rows.
pub fn label(labels: &mut Labels, solved: &Elimination, names: &[String]) {
    for (equation, row) in solved.left.iter().zip(names) {
        for (coefficient, column) in equation.coefficients.iter().zip(names) {
            labels.name(*coefficient, format!("{row}_by_{column}"));
        }
        labels.name(equation.right, format!("{row}_to_balance"));
    }
    labels.explain(solved.pivots.iter().map(|(_, inverse)| *inverse), GUARDED);
}

/// `M x - P l = f`, `A x + c l = r`. The matrix is not definite. The loads, whose divisors are
/// compared as `of_load` says, are eliminated last.
pub fn together(
    work: &mut Workspace,
    (masses, driving): (&[Vec<Id>], &[Id]),
    rows: &[LoadedRow],
    of_load: Size,
) -> Vec<Equation> {
    let (count, zero) = (driving.len(), work.graph.zero());
    let mut sides = Vec::new();
    for (own, (masses, right)) in masses.iter().zip(driving).enumerate() {
        let mut coefficients = masses.clone();
        let pushes = rows.iter().map(|row| work.graph.negate(row.pushes[own]));
        coefficients.extend(pushes);
        sides.push((coefficients, *right, (own, Size::Squares)));
    }
    for (number, row) in rows.iter().enumerate() {
        let mut coefficients = [row.slopes.clone(), vec![zero; rows.len()]].concat();
        coefficients[count + number] = row.own;
        sides.push((coefficients, row.right, (count + number, of_load)));
    }
    let all: Vec<Id> = sides.iter().flat_map(|(row, ..)| row.clone()).collect();
    let mut values = samples(work, &all).into_iter();
    let equations = sides.into_iter().map(|(coefficients, right, (own, size))| {
        let mut sizes = vec![Size::Beside; coefficients.len()];
        sizes[own] = size;
        Equation {
            sample: values.by_ref().take(coefficients.len()).collect(),
            sizes,
            active: None,
            coefficients,
            right,
        }
    });
    equations.collect()
}
