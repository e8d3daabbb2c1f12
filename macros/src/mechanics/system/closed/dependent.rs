//! Rows that depend on each other in closed states: the motion, and the constraint loads with the
//! least sum of squares.
//!
//! ```text
//! S l = r        S = A M^-1 A^T, of rank k in closed states, where r is in its range
//!
//! l = N_k r / e_k        N_1 = 1,  N_(j+1) = e_j - S N_j,  e_j = tr(S N_j) / j
//! ```
//!
//! This is the Cayley-Hamilton theorem on the range. `e_k` is the sum of all principal minors of k
//! rows, so no row is preferred. S has no negative eigenvalue, so `e_k` vanishes only where the
//! rank is below k. That the rank is k is neither proved nor assumed: if `S l` differs from r by
//! more than rounding and the distance of the state from a closed one explain, the result is NaN.
//! Otherwise all rows are satisfied and all balances hold, which determines the motion.
//!
//! Bodies without mass may make M singular, so that only the rows hold what they can do. Then the
//! rows are added to it, with positive weights W:
//!
//! ```text
//! (M + A^T W A) q'' - A^T l = f - A^T W b        A q'' = -b
//! ```
//!
//! The accelerations and the loads are the same. This sum is positive if the motion is determined:
//! M has no negative eigenvalue, and what neither M nor A resists is not determined.

use crate::mechanics::tree::MassMatrix;
use crate::model::{Labels, Workspace};
use crate::symbolic::{Equation, Graph, Id};

use super::super::constraints::ConstraintRow;
use super::super::reduced::label;
use super::eliminated::{Following, Found, equations, names};
use super::groups::{Group, full};
use super::guard::{Closeness, guard};
use super::rows::Owner;
use super::semidefinite::Solver;

/// What remains for the rows of `groups` once the masses and the rows that are always independent
/// are eliminated.
struct Left {
    /// The rows that are always independent.
    full: Vec<usize>,
    groups: Vec<Group>,
    /// The rows of all groups, in order.
    rows: Vec<usize>,
    /// The accelerations and the loads of the other rows: without loads of these rows, and per unit
    /// load of each of these rows.
    base: Vec<Id>,
    units: Vec<Vec<Id>>,
    matrix: Vec<Vec<Id>>,
    right: Vec<Id>,
    /// For each row, a bound of its diagonal entry in `matrix`.
    bounds: Vec<Id>,
}

/// Solves for accelerations and loads, if no loads depend on these. `None` if this is not needed or
/// not possible. Where the motion `is_settled`, masses and the rows that are always independent
/// determine it in closed states, if they do in others.
pub fn dependent(
    work: &mut Workspace,
    (matrix, is_settled): (&MassMatrix, bool),
    kept: &[(Owner, ConstraintRow)],
    groups: &[Group],
    (rates, is_turning): (&[Id], &[bool]),
) -> Option<Found> {
    let count = matrix.driving.len();
    let closeness = Closeness::of(&mut work.graph, kept, rates, is_turning);
    let plain = is_settled.then(|| left(work, matrix, kept, groups));
    let left = plain.flatten().or_else(|| {
        let held = held(&mut work.graph, matrix, kept, groups);
        left(work, &held, kept, groups)
    })?;
    let graph = &mut work.graph;
    let solver = {
        let groups = left.groups.iter();
        let ranks: Vec<(usize, usize)> = groups
            .map(|group| (group.rows.len(), group.rank()))
            .collect();
        Solver::new(graph, (&left.matrix, &left.bounds), &ranks)
    };
    let loads = solver.solve(graph, &left.right);
    let of_loads = of_loads(graph, matrix);
    let holds = guard_of(
        graph,
        &left,
        (kept, &loads),
        (&closeness, &solver),
        of_loads,
    )?;
    let labels = &mut work.labels;
    left.label(labels, &matrix.names, (kept, &loads));
    closeness.label(labels);
    labels.name(holds, "holds");
    labels.describe("holds", "1, or NaN if the rows contradict each other");
    let all = combined(graph, &left.base, &left.units, &loads);
    let all: Vec<Id> = all
        .into_iter()
        .map(|one| {
            let one = graph.multiply(holds, one);
            graph.quantity(one)
        })
        .collect();
    let held = loads.iter().map(|load| graph.multiply(holds, *load));
    let held: Vec<Id> = held.collect();
    let (accelerations, of_full) = all.split_at(count);
    let rows = [&left.full[..], &left.rows].concat();
    let loads = by_row(graph, &rows, (of_full, &held));
    let (mut loose, mut follows) = (Vec::new(), vec![false; kept.len()]);
    for own in left.spare() {
        let (of_full, of_left) = left.balanced(graph, &solver, own, count);
        follows[left.rows[own]] = true;
        loose.push(by_row(graph, &rows, (&of_full, &of_left)));
    }
    Some(Found {
        accelerations: accelerations.to_vec(),
        loads,
        is_resolved: false,
        spare: Vec::new(),
        loose,
        follows,
        light: Vec::new(),
    })
}

/// The loads in the order of all rows, from loads that are ordered by `rows`.
fn by_row(graph: &Graph, rows: &[usize], (first, others): (&[Id], &[Id])) -> Vec<Id> {
    let mut loads = vec![graph.zero(); rows.len()];
    for (row, load) in rows.iter().zip(first.iter().chain(others)) {
        loads[*row] = *load;
    }
    loads
}

/// The masses and their loads, with those that the rows add in their directions where they hold.
/// Rows that follow from others in all closed states are not needed, and may vanish there.
fn held(
    graph: &mut Graph,
    matrix: &MassMatrix,
    kept: &[(Owner, ConstraintRow)],
    groups: &[Group],
) -> MassMatrix {
    let mut all = matrix.clone();
    for group in groups.iter().filter(|group| group.rank() > 0) {
        let rows: Vec<&ConstraintRow> = group.rows.iter().map(|row| &kept[*row].1).collect();
        let bounds = rows.iter().map(|row| bound(graph, matrix, row));
        let bounds: Vec<Id> = bounds.collect();
        let (bounds, one) = (graph.sum(&bounds), graph.one());
        let weight = graph.divide(one, bounds);
        let weight = graph.quantity(weight);
        for row in rows {
            for (own, slope) in row.slopes.iter().enumerate() {
                let push = graph.multiply(weight, *slope);
                for (other, factor) in row.slopes.iter().enumerate().take(own + 1) {
                    let added = graph.multiply(push, *factor);
                    let entry = graph.add(all.rows[own][other], added);
                    all.rows[own][other] = entry;
                    all.rows[other][own] = entry;
                }
                let load = graph.multiply(push, row.bias);
                all.driving[own] = graph.subtract(all.driving[own], load);
            }
        }
    }
    all
}

/// The acceleration of a row per unit of its load, if masses do not couple the coordinates; one where
/// it is trivial.
fn bound(graph: &mut Graph, matrix: &MassMatrix, row: &ConstraintRow) -> Id {
    let trivial = row.triviality(graph);
    let alone = row.slopes.iter().enumerate().map(|(freedom, slope)| {
        let square = graph.square(*slope);
        graph.divide(square, matrix.rows[freedom][freedom])
    });
    let all: Vec<Id> = alone.chain([trivial]).collect();
    graph.sum(&all)
}

/// Eliminates the masses and the rows that are always independent. `None` if masses and these rows
/// do not determine the motion.
fn left(
    work: &mut Workspace,
    matrix: &MassMatrix,
    kept: &[(Owner, ConstraintRow)],
    groups: &[Group],
) -> Option<Left> {
    let count = matrix.driving.len();
    let full = full(groups);
    let groups = groups.iter().filter(|group| !group.is_full());
    let groups: Vec<Group> = groups.cloned().collect();
    let rows: Vec<&ConstraintRow> = full.iter().map(|row| &kept[*row].1).collect();
    let following = Following {
        loads: &vec![None; rows.len()],
        accelerations: &[],
    };
    let equations = equations(work, matrix, &rows, following);
    let unknowns = count + rows.len();
    let graph = &mut work.graph;
    let solved = graph.solve(equations.clone(), unknowns);
    if !solved.undetermined.is_empty() {
        return None;
    }
    let names = names(matrix, &rows);
    label(&mut work.labels, &solved, &names);
    for (value, name) in solved.values.iter().zip(&names) {
        work.labels.name(*value, format!("{name}_alone"));
    }
    let rows: Vec<usize> = groups.iter().flat_map(|group| group.rows.clone()).collect();
    let units: Vec<Vec<Id>> = rows
        .iter()
        .map(|row| {
            let equations = pushed(graph, &equations, &kept[*row].1.slopes);
            graph.solve(equations, unknowns).values
        })
        .collect();
    let base = solved.values;
    let mut left = Left {
        matrix: vec![vec![graph.zero(); rows.len()]; rows.len()],
        right: Vec::new(),
        bounds: Vec::new(),
        full,
        groups,
        base,
        units,
        rows,
    };
    for (own, row) in left.rows.iter().enumerate() {
        let row = &kept[*row].1;
        for other in own..left.rows.len() {
            let entry = graph.inner(&row.slopes, &left.units[other][..count]);
            let entry = graph.quantity(entry);
            left.matrix[own][other] = entry;
            left.matrix[other][own] = entry;
        }
        let moved = graph.inner(&row.slopes, &left.base[..count]);
        let right = graph.add(row.bias, moved);
        let right = graph.negate(right);
        left.right.push(graph.quantity(right));
        left.bounds.push(bound(graph, matrix, row));
    }
    Some(left)
}

impl Left {
    /// The dependent rows, by their index among the rows of all groups.
    fn spare(&self) -> Vec<usize> {
        let all = self.groups.iter().flat_map(|group| &group.is_independent);
        let spare = all.enumerate().filter(|(_, is_new)| !**is_new);
        spare.map(|(own, _)| own).collect()
    }

    /// Names its parts, and the loads of its rows.
    fn label(
        &self,
        labels: &mut Labels,
        coordinates: &[String],
        (kept, loads): (&[(Owner, ConstraintRow)], &[Id]),
    ) {
        let names: Vec<String> = self.rows.iter().map(|row| kept[*row].1.spelled()).collect();
        for (own, name) in names.iter().enumerate() {
            for (acceleration, coordinate) in self.units[own].iter().zip(coordinates) {
                labels.name(*acceleration, format!("{coordinate}_per_{name}"));
            }
            labels.name(self.matrix[own][own], format!("inverse_mass_{name}"));
            for (entry, second) in self.matrix[own].iter().zip(&names).skip(own + 1) {
                labels.name(*entry, format!("inverse_mass_{name}_{second}"));
            }
            labels.name(self.right[own], format!("{name}_to_close"));
            labels.name(loads[own], format!("{name}_load"));
        }
    }

    /// A unit load of one row, and the loads that balance it: those of the rows that are always
    /// independent, and those of these rows. `count` is the number of accelerations.
    fn balanced(
        &self,
        graph: &mut Graph,
        solver: &Solver,
        own: usize,
        count: usize,
    ) -> (Vec<Id>, Vec<Id>) {
        let column: Vec<Id> = self.matrix.iter().map(|row| row[own]).collect();
        let others = solver.solve(graph, &column);
        let mut of_left: Vec<Id> = others.into_iter().map(|one| graph.negate(one)).collect();
        let one = graph.one();
        of_left[own] = graph.add(of_left[own], one);
        let zeros = vec![graph.zero(); self.base.len()];
        let mut of_full = combined(graph, &zeros, &self.units, &of_left);
        (of_full.split_off(count), of_left)
    }
}

/// The equations for the effect of a unit load of one row.
fn pushed(graph: &Graph, equations: &[Equation], slopes: &[Id]) -> Vec<Equation> {
    let zero = graph.zero();
    let rights = slopes.iter().copied().chain(std::iter::repeat(zero));
    let equations = equations.iter().zip(rights);
    let equations = equations.map(|(equation, right)| Equation {
        right,
        ..equation.clone()
    });
    equations.collect()
}

/// `base + sum of factors * units`
fn combined(graph: &mut Graph, base: &[Id], units: &[Vec<Id>], factors: &[Id]) -> Vec<Id> {
    let all = base.iter().enumerate().map(|(place, base)| {
        let parts = units.iter().map(|unit| unit[place]);
        let parts: Vec<Id> = parts.collect();
        let change = graph.inner(factors, &parts);
        graph.add(*base, change)
    });
    all.collect()
}

/// The squares of the accelerations of all coordinates by their loads, in the metric of the kinetic
/// energy, if masses do not couple them.
fn of_loads(graph: &mut Graph, matrix: &MassMatrix) -> Id {
    let mut parts = Vec::new();
    for (own, load) in matrix.driving.iter().enumerate() {
        let mass = matrix.rows[own][own];
        if !graph.is_zero(mass) {
            let square = graph.square(*load);
            parts.push(graph.divide(square, mass));
        }
    }
    graph.sum(&parts)
}

/// One if all rows are satisfied with these loads, otherwise NaN. `of_loads` bounds the
/// accelerations from which rows leave only rounding errors.
fn guard_of(
    graph: &mut Graph,
    left: &Left,
    (kept, loads): (&[(Owner, ConstraintRow)], &[Id]),
    (closeness, solver): (&Closeness, &Solver),
    of_loads: Id,
) -> Option<Id> {
    let count = kept.first()?.1.slopes.len();
    let mut sizes = solver.steps.iter().map(|step| step.size);
    let changing = sizes.find(|size| graph.as_number(*size).is_none())?;
    let (mut holds, mut passed) = (graph.one(), of_loads);
    for (step, group) in solver.steps.iter().zip(&left.groups) {
        let (mut lacking, mut sizes, mut rows) = (Vec::new(), Vec::new(), Vec::new());
        for own in step.own.clone() {
            let row = &kept[left.rows[own]].1;
            let done = graph.inner(&left.matrix[own], loads);
            let lacks = graph.subtract(left.right[own], done);
            lacking.push(graph.square(lacks));
            let parts = row.slopes.iter().zip(&left.base[..count]);
            let parts = parts.chain(left.matrix[own].iter().zip(loads));
            let mut parts: Vec<Id> = parts.map(|(a, b)| graph.multiply(*a, *b)).collect();
            // bodies that move together leave only rounding errors of what they have in common
            parts.extend(graph.magnitudes(&[row.bias]));
            sizes.extend(parts.into_iter().map(|part| graph.square(part)));
            rows.push(row);
        }
        let (lacking, own) = (graph.sum(&lacking), graph.sum(&sizes));
        // rounding errors of loads push later rows too
        let sizes = graph.multiply(passed, step.size);
        let sizes = graph.add(own, sizes);
        if group.rank() > 0 {
            let own = graph.divide(own, step.size);
            passed = graph.add(passed, own);
        }
        let size = match graph.as_number(step.size) {
            Some(_) => changing,
            None => step.size,
        };
        let of_group = guard(graph, (lacking, sizes), (&rows, closeness), size);
        holds = graph.multiply(holds, of_group);
    }
    Some(graph.quantity(holds))
}
