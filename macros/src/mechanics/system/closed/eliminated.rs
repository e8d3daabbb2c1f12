//! Accelerations and loads, solved for together by elimination: the masses first.

use crate::mechanics::tree::MassMatrix;
use crate::model::Workspace;
use crate::symbolic::{Equation, Id, Size};

use super::super::constraints::{ConstraintRow, split};
use super::super::reduced::{LoadedRow, label, together};
use super::rows::Owner;
use super::undetermined::{open, without_column};

/// The solution for a system with rows.
pub struct Found {
    /// The accelerations of the open coordinates.
    pub accelerations: Vec<Id>,
    /// The loads of the rows.
    pub loads: Vec<Id>,
    /// Whether the motion does not depend on the loads.
    pub is_resolved: bool,
    /// Rows whose loads are not determined. For each: the rows that can replace it, and the loads
    /// of all rows that balance one unit of its load.
    pub spare: Vec<(usize, Vec<usize>, Vec<Id>)>,
    /// Sets of loads of all rows that balance each other in closed states.
    pub loose: Vec<Vec<Id>>,
    /// For each row, whether it follows from others in closed states.
    pub follows: Vec<bool>,
    /// Coordinates whose inertia is canceled by loads that depend on accelerations.
    pub light: Vec<usize>,
}

/// The symbols that loads may depend on.
#[derive(Clone, Copy)]
pub struct Following<'a> {
    /// The symbols of the loads of rows.
    pub loads: &'a [Option<Id>],
    /// The symbols of the accelerations of open coordinates.
    pub accelerations: &'a [Id],
}

/// Solves for the accelerations of the coordinates and for loads. Loads may depend on the symbols in `following`.
pub fn eliminated(
    work: &mut Workspace,
    matrix: &MassMatrix,
    kept: &[(Owner, ConstraintRow)],
    following: Following<'_>,
) -> Found {
    let count = matrix.driving.len();
    let rows: Vec<&ConstraintRow> = kept.iter().map(|(_, row)| row).collect();
    let equations = equations(work, matrix, &rows, following);
    let solved = work.graph.solve(equations.clone(), count + kept.len());
    label(&mut work.labels, &solved, &names(matrix, &rows));
    // loads that balance each other: a unit of each undetermined load, with the loads of others
    // that it needs
    let mut spare = Vec::new();
    for (row, others) in open(&solved, count) {
        let equations = without_column(&mut work.graph, &equations, count + row);
        let values = work.graph.solve(equations, count + kept.len() - 1).values;
        let mut loads: Vec<Id> = values.into_iter().skip(count).collect();
        loads.insert(row, work.graph.one());
        spare.push((row, others, loads));
    }
    let columns = solved.undetermined.iter().map(|one| one.column);
    let light = columns.filter(|column| *column < count).collect();
    let mut accelerations = solved.values;
    let loads = accelerations.split_off(count);
    Found {
        accelerations,
        loads,
        is_resolved: false,
        spare,
        loose: Vec::new(),
        follows: vec![false; kept.len()],
        light,
    }
}

/// The names of the coordinates, and then of the rows.
pub fn names(matrix: &MassMatrix, rows: &[&ConstraintRow]) -> Vec<String> {
    let rows = rows.iter().map(|row| row.spelled());
    matrix.names.iter().cloned().chain(rows).collect()
}

/// `M q'' - A^T l = f` and `A q'' = -b`, for the accelerations and then the loads l. The part of f
/// that depends on these, through their symbols, is moved to the left side.
pub fn equations(
    work: &mut Workspace,
    matrix: &MassMatrix,
    constraints: &[&ConstraintRow],
    Following {
        loads: followed,
        accelerations,
    }: Following<'_>,
) -> Vec<Equation> {
    let (zero, count) = (work.graph.zero(), matrix.driving.len());
    let (driving, fed_back) = split(&mut work.graph, &matrix.driving, accelerations);
    let is_fed_back = fed_back
        .iter()
        .flatten()
        .any(|slope| !work.graph.is_zero(*slope));
    let mut masses = matrix.rows.clone();
    for (column, slopes) in fed_back.iter().enumerate() {
        for (row, slope) in masses.iter_mut().zip(slopes) {
            row[column] = work.graph.subtract(row[column], *slope);
        }
    }
    let symbols: Vec<Id> = followed.iter().flatten().copied().collect();
    let (driving, following) = split(&mut work.graph, &driving, &symbols);
    let mut slopes = following.iter().flatten();
    let is_followed = slopes.any(|slope| !work.graph.is_zero(*slope));
    let rows = constraints.iter().zip(followed).map(|(row, symbol)| {
        let number = symbols.iter().position(|one| Some(*one) == *symbol);
        let pushes = row.slopes.iter().enumerate().map(|(freedom, slope)| {
            let follows = number.map_or(zero, |number| following[number][freedom]);
            work.graph.add(*slope, follows)
        });
        LoadedRow {
            pushes: pushes.collect(),
            slopes: row.slopes.clone(),
            right: work.graph.negate(row.bias),
            own: row.triviality(&mut work.graph),
        }
    });
    let rows: Vec<LoadedRow> = rows.collect();
    // if no loads depend on unknowns, elimination leaves `-A M^-1 A^T` for the rows
    let of_load = if is_followed || is_fed_back {
        Size::Beside
    } else {
        Size::Reduced
    };
    let mut equations = together(work, (&masses, &driving), &rows, of_load);
    if is_fed_back {
        // what loads add to masses need not be positive; but slopes of rows cancel where loops are
        // closed, so masses are the first divisors
        let size = if rows.is_empty() {
            Size::Terms
        } else {
            Size::Masses
        };
        for (row, equation) in equations.iter_mut().enumerate().take(count) {
            equation.sizes[row] = size;
        }
    }
    equations
}
