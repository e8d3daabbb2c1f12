//! Accelerations and loads together, by elimination: the masses first.

use crate::mechanics::proofs::samples;
use crate::mechanics::tree::MassMatrix;
use crate::model::Workspace;
use crate::symbolic::{Equation, Id, Size};

use super::followers::split;
use super::row::Row;
use super::unsettled::{Keeper, open, without_column};

/// What is found of a system that is held by rows.
pub struct Found {
    /// Of the open freedoms.
    pub accelerations: Vec<Id>,
    /// Of the rows.
    pub loads: Vec<Id>,
    /// Whether the motion takes no loads.
    pub is_resolved: bool,
    /// Rows whose loads are not determined, with those that can do all that each does, and the loads
    /// of all rows that balance one unit of it.
    pub spare: Vec<(usize, Vec<usize>, Vec<Id>)>,
}

/// Solves for accelerations and loads; loads that follow those of rows do so by these symbols.
pub fn eliminated(
    work: &mut Workspace,
    matrix: &MassMatrix,
    kept: &[(Keeper, Row)],
    followed: &[Option<Id>],
) -> Found {
    let count = matrix.driving.len();
    let rows: Vec<&Row> = kept.iter().map(|(_, row)| row).collect();
    let equations = equations(work, matrix, &rows, followed);
    let solved = work.graph.solve(equations.clone(), count + kept.len());
    // what balances by itself: a unit of each load that is not determined, with what it takes of others
    let mut spare = Vec::new();
    for (row, others) in open(&solved, count) {
        let equations = without_column(&mut work.graph, &equations, count + row);
        let values = work.graph.solve(equations, count + kept.len() - 1).values;
        let mut loads: Vec<Id> = values.into_iter().skip(count).collect();
        loads.insert(row, work.graph.one());
        spare.push((row, others, loads));
    }
    let mut accelerations = solved.values;
    let loads = accelerations.split_off(count);
    Found {
        accelerations,
        loads,
        is_resolved: false,
        spare,
    }
}

/// `M q'' - A^T l = f` and `A q'' = -b`, for the accelerations and then the loads l; what of f follows
/// these, by its symbols, is on the left.
fn equations(
    work: &mut Workspace,
    matrix: &MassMatrix,
    constraints: &[&Row],
    followed: &[Option<Id>],
) -> Vec<Equation> {
    let loads = constraints.len();
    let zero = work.graph.zero();
    let symbols: Vec<Id> = followed.iter().flatten().copied().collect();
    let (driving, following) = split(&mut work.graph, &matrix.driving, &symbols);
    let mut slopes = following.iter().flatten();
    let is_followed = slopes.any(|slope| !work.graph.is_zero(*slope));
    let following = |symbol: &Option<Id>, freedom: usize| {
        let number = symbols.iter().position(|one| Some(*one) == *symbol)?;
        Some(following[number][freedom])
    };
    let mut sides = Vec::new();
    for (freedom, row) in matrix.rows.iter().enumerate() {
        let mut coefficients = row.clone();
        for (row, symbol) in constraints.iter().zip(followed) {
            let follows = following(symbol, freedom).unwrap_or(zero);
            let whole = work.graph.add(row.slopes[freedom], follows);
            coefficients.push(work.graph.negate(whole));
        }
        sides.push((coefficients, driving[freedom], (freedom, Size::Squares)));
    }
    // without loads that follow others, `-A M^-1 A^T` is left of their rows
    let of_load = if is_followed {
        Size::Beside
    } else {
        Size::Reduced
    };
    let one = work.graph.one();
    for (number, row) in constraints.iter().enumerate() {
        let mut coefficients = [row.slopes.clone(), vec![zero; loads]].concat();
        // where it says nothing, its load is zero
        if let Some(active) = row.active {
            coefficients[matrix.driving.len() + number] = work.graph.select(active, zero, one);
        }
        let own = (matrix.driving.len() + number, of_load);
        sides.push((coefficients, work.graph.negate(row.bias), own));
    }
    let all: Vec<Id> = sides.iter().flat_map(|(row, ..)| row.clone()).collect();
    let mut values = samples(work, &all).into_iter();
    let equations = sides.into_iter().map(|(coefficients, right, (own, size))| {
        // the matrix is not definite: the loads are eliminated last
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
