//! Rows that depend on each other in closed states: the motion, and loads that keep it, of the least
//! squares of their numbers.
//!
//! ```text
//! S l = r        S = A M^-1 A^T, of rank k in closed states, where r is in its range
//!
//! l = N_k r / e_k        N_1 = 1,  N_(j+1) = e_j - S N_j,  e_j = tr(S N_j) / j
//! ```
//!
//! by the theorem of Cayley and Hamilton on the range: e_k is the sum of all minors of k rows, and no row
//! is preferred. S has no negative eigenvalue, so that it vanishes only where the rank is less. That the
//! rank is k is not proved, and not taken for granted: where `S l` differs from r by more than rounding and
//! what the state lacks of a closed one, all is not a number. Where it does not, all rows are kept and all
//! balances hold, and this determines the motion.

use crate::mechanics::tree::MassMatrix;
use crate::model::Workspace;
use crate::symbolic::{Equation, Graph, Id};

use super::super::constraints::Row;
use super::eliminated::{Following, Found, equations};
use super::guard::{Closeness, guard};
use super::unsettled::Keeper;

/// Rows of one joint and of one dimension, and how many of them are independent.
pub struct Group {
    pub rows: Vec<usize>,
    pub rank: usize,
}

/// Groups of rows, of which these are independent of those before them.
pub fn groups(graph: &Graph, kept: &[(Keeper, Row)], independent: &[bool]) -> Vec<Group> {
    let mut groups: Vec<(Option<(usize, bool)>, Group)> = Vec::new();
    for (number, ((keeper, _), is_new)) in kept.iter().zip(independent).enumerate() {
        let own = keeper.joint_part(graph);
        let rank = usize::from(*is_new);
        match groups.last_mut() {
            Some((last, group)) if own.is_some() && *last == own => {
                group.rows.push(number);
                group.rank += rank;
            }
            _ => {
                let rows = vec![number];
                groups.push((own, Group { rows, rank }));
            }
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

/// What each row of `groups` does beside those that are always independent, and what these leave.
struct Left {
    groups: Vec<Group>,
    /// The rows of all groups, in order.
    rows: Vec<usize>,
    /// Accelerations and the loads of the others, without loads of these rows, and by a unit of each.
    base: Vec<Id>,
    units: Vec<Vec<Id>>,
    matrix: Vec<Vec<Id>>,
    right: Vec<Id>,
    /// By row, a bound of what is in `matrix` on its diagonal.
    bounds: Vec<Id>,
}

/// Solves for accelerations and loads, that follow none; nothing if there is no need or no way.
pub fn dependent(
    work: &mut Workspace,
    matrix: &MassMatrix,
    kept: &[(Keeper, Row)],
    groups: Vec<Group>,
    (rates, is_turning): (&[Id], &[bool]),
) -> Option<Found> {
    let count = matrix.driving.len();
    let (full, groups): (Vec<Group>, Vec<Group>) = groups
        .into_iter()
        .partition(|group| group.rank == group.rows.len());
    let full: Vec<usize> = full.into_iter().flat_map(|group| group.rows).collect();
    let closeness = Closeness::of(&mut work.graph, kept, rates, is_turning);
    let left = left(work, matrix, kept, (&full, groups))?;
    let graph = &mut work.graph;
    let solver = Solver::new(graph, &left);
    let loads = solver.solve(graph, &left.right);
    let holds = guard_of(graph, &left, (kept, &loads), (&closeness, &solver))?;
    let all = combined(graph, &left.base, &left.units, &loads);
    let all: Vec<Id> = all
        .into_iter()
        .map(|one| {
            let one = graph.multiply(holds, one);
            graph.quantity(one)
        })
        .collect();
    let spread = |graph: &mut Graph, of_full: &[Id], of_left: &[Id]| {
        let mut loads = vec![graph.zero(); kept.len()];
        for (row, load) in full
            .iter()
            .zip(of_full)
            .chain(left.rows.iter().zip(of_left))
        {
            loads[*row] = *load;
        }
        loads
    };
    let held: Vec<Id> = loads
        .iter()
        .map(|load| graph.multiply(holds, *load))
        .collect();
    let loads = spread(graph, &all[count..], &held);
    let mut loose = Vec::new();
    for own in left.spare() {
        // what others balance of a unit of this load
        let column: Vec<Id> = left.matrix.iter().map(|row| row[own]).collect();
        let others = solver.solve(graph, &column);
        let mut of_left: Vec<Id> = others.into_iter().map(|one| graph.negate(one)).collect();
        of_left[own] = {
            let one = graph.one();
            graph.add(of_left[own], one)
        };
        let zeros = vec![graph.zero(); left.base.len()];
        let all = combined(graph, &zeros, &left.units, &of_left);
        loose.push(spread(graph, &all[count..], &of_left));
    }
    Some(Found {
        accelerations: all[..count].to_vec(),
        loads,
        is_resolved: false,
        spare: Vec::new(),
        loose,
        light: Vec::new(),
    })
}

/// Eliminates the masses and the rows that are always independent.
fn left(
    work: &mut Workspace,
    matrix: &MassMatrix,
    kept: &[(Keeper, Row)],
    (full, groups): (&[usize], Vec<Group>),
) -> Option<Left> {
    let count = matrix.driving.len();
    let held: Vec<&Row> = full.iter().map(|row| &kept[*row].1).collect();
    let following = Following {
        loads: &vec![None; held.len()],
        accelerations: &[],
    };
    let equations = equations(work, matrix, &held, following);
    let unknowns = count + held.len();
    let graph = &mut work.graph;
    let solved = graph.solve(equations.clone(), unknowns);
    if !solved.undetermined.is_empty() {
        return None;
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
        groups,
        base,
        units,
        rows,
    };
    for (own, row) in left.rows.iter().enumerate() {
        let row = &kept[*row].1;
        for other in own..left.rows.len() {
            let entry = product(graph, &row.slopes, &left.units[other][..count]);
            let entry = graph.quantity(entry);
            left.matrix[own][other] = entry;
            left.matrix[other][own] = entry;
        }
        let moved = product(graph, &row.slopes, &left.base[..count]);
        let right = graph.add(row.bias, moved);
        let right = graph.negate(right);
        left.right.push(graph.quantity(right));
        let alone = row.slopes.iter().enumerate().map(|(freedom, slope)| {
            let square = graph.square(*slope);
            graph.divide(square, matrix.rows[freedom][freedom])
        });
        let alone: Vec<Id> = alone.collect();
        left.bounds.push(graph.sum(&alone));
    }
    Some(left)
}

impl Left {
    /// As many rows of each group as depend on others.
    fn spare(&self) -> Vec<usize> {
        let mut first = 0;
        let mut spare = Vec::new();
        for group in &self.groups {
            spare.extend(first + group.rank..first + group.rows.len());
            first += group.rows.len();
        }
        spare
    }
}

/// The equations of what a unit of a load does alone.
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

fn product(graph: &mut Graph, first: &[Id], second: &[Id]) -> Id {
    let parts = first.iter().zip(second);
    let parts: Vec<Id> = parts.map(|(a, b)| graph.multiply(*a, *b)).collect();
    graph.sum(&parts)
}

/// `base + sum of factors * units`
fn combined(graph: &mut Graph, base: &[Id], units: &[Vec<Id>], factors: &[Id]) -> Vec<Id> {
    let all = base.iter().enumerate().map(|(place, base)| {
        let parts = units.iter().map(|unit| unit[place]);
        let parts: Vec<Id> = parts.collect();
        let change = product(graph, factors, &parts);
        graph.add(*base, change)
    });
    all.collect()
}

/// Group after group is eliminated.
struct Solver {
    steps: Vec<Step>,
}

struct Step {
    own: std::ops::Range<usize>,
    /// `N_k / e_k` of these rows, once those before are eliminated.
    inverse: Vec<Vec<Id>>,
    /// Of the rows behind: what they take of these, and what these take of them.
    later: Vec<Vec<Id>>,
    /// Is positive.
    size: Id,
}

impl Solver {
    fn new(graph: &mut Graph, left: &Left) -> Self {
        let mut matrix = left.matrix.clone();
        let (mut first, mut steps) = (0, Vec::new());
        for group in &left.groups {
            let own = first..first + group.rows.len();
            first = own.end;
            let block: Vec<Vec<Id>> = own
                .clone()
                .map(|row| matrix[row][own.clone()].to_vec())
                .collect();
            let size = graph.sum(&left.bounds[own.clone()]);
            let size = graph.quantity(size);
            let inverse = inverse(graph, &block, group.rank, size);
            let later: Vec<Vec<Id>> = (first..matrix.len())
                .map(|row| matrix[row][own.clone()].to_vec())
                .collect();
            for (row, factors) in (first..matrix.len()).zip(&later) {
                let taken = of_matrix(graph, &inverse, factors);
                for column in first..matrix.len() {
                    let less = product(graph, &taken, &later[column - first]);
                    let entry = graph.subtract(matrix[row][column], less);
                    matrix[row][column] = graph.quantity(entry);
                }
            }
            steps.push(Step {
                own,
                inverse,
                later,
                size,
            });
        }
        Self { steps }
    }

    fn solve(&self, graph: &mut Graph, right: &[Id]) -> Vec<Id> {
        let mut right = right.to_vec();
        for step in &self.steps {
            let known = of_matrix(graph, &step.inverse, &right[step.own.clone()]);
            for (row, factors) in step.later.iter().enumerate() {
                let less = product(graph, factors, &known);
                let place = step.own.end + row;
                let left = graph.subtract(right[place], less);
                right[place] = graph.quantity(left);
            }
        }
        let mut values = vec![graph.zero(); right.len()];
        for step in self.steps.iter().rev() {
            let known: Vec<Id> = step
                .own
                .clone()
                .enumerate()
                .map(|(place, row)| {
                    let slopes: Vec<Id> = step.later.iter().map(|later| later[place]).collect();
                    let less = product(graph, &slopes, &values[step.own.end..]);
                    graph.subtract(right[row], less)
                })
                .collect();
            let found = of_matrix(graph, &step.inverse, &known);
            for (row, value) in step.own.clone().zip(found) {
                values[row] = graph.quantity(value);
            }
        }
        values
    }
}

/// `N_k / e_k`; `size` is one of the eigenvalues.
fn inverse(graph: &mut Graph, block: &[Vec<Id>], rank: usize, size: Id) -> Vec<Vec<Id>> {
    let count = block.len();
    let (zero, one) = (graph.zero(), graph.one());
    if rank == 0 {
        return vec![vec![zero; count]; count];
    }
    let unit = |own: usize, other: usize, value: Id| if own == other { value } else { zero };
    let mut along: Vec<Vec<Id>> = (0..count)
        .map(|own| (0..count).map(|other| unit(own, other, one)).collect())
        .collect();
    let mut degree = 1;
    loop {
        let next: Vec<Vec<Id>> = (0..count)
            .map(|own| {
                let column = |other: usize| along.iter().map(|row| row[other]).collect::<Vec<Id>>();
                (0..count)
                    .map(|other| product(graph, &block[own], &column(other)))
                    .collect()
            })
            .collect();
        let trace: Vec<Id> = (0..count).map(|own| next[own][own]).collect();
        let trace = graph.sum(&trace);
        let degree_of = graph.integer(degree);
        let sum = graph.divide(trace, degree_of);
        let sum = graph.quantity(sum);
        if usize::try_from(degree) == Ok(rank) {
            let bound = graph.powi(size, i32::try_from(rank).unwrap_or(1));
            let pivot = graph.checked_reciprocal(sum, bound);
            let all = along.iter().map(|row| {
                let row = row.iter().map(|entry| {
                    let entry = graph.multiply(pivot, *entry);
                    graph.quantity(entry)
                });
                row.collect()
            });
            return all.collect();
        }
        for own in 0..count {
            for other in 0..count {
                let entry = graph.subtract(unit(own, other, sum), next[own][other]);
                along[own][other] = graph.quantity(entry);
            }
        }
        degree += 1;
    }
}

fn of_matrix(graph: &mut Graph, matrix: &[Vec<Id>], vector: &[Id]) -> Vec<Id> {
    let all = matrix.iter().map(|row| product(graph, row, vector));
    all.collect()
}

/// One where all rows hold with these loads, and not a number elsewhere.
fn guard_of(
    graph: &mut Graph,
    left: &Left,
    (kept, loads): (&[(Keeper, Row)], &[Id]),
    (closeness, solver): (&Closeness, &Solver),
) -> Option<Id> {
    let count = kept.first()?.1.slopes.len();
    let mut holds = graph.one();
    for step in &solver.steps {
        let (mut lacking, mut sizes, mut rows) = (Vec::new(), Vec::new(), Vec::new());
        for own in step.own.clone() {
            let row = &kept[left.rows[own]].1;
            let done = product(graph, &left.matrix[own], loads);
            let lacks = graph.subtract(left.right[own], done);
            lacking.push(graph.square(lacks));
            let parts = row.slopes.iter().zip(&left.base[..count]);
            let parts = parts.chain(left.matrix[own].iter().zip(loads));
            let mut parts: Vec<Id> = parts.map(|(a, b)| graph.multiply(*a, *b)).collect();
            parts.push(row.bias);
            sizes.extend(parts.into_iter().map(|part| graph.square(part)));
            rows.push(row);
        }
        let (lacking, sizes) = (graph.sum(&lacking), graph.sum(&sizes));
        let of_group = guard(graph, (lacking, sizes), (&rows, closeness), step.size)?;
        holds = graph.multiply(holds, of_group);
    }
    Some(graph.quantity(holds))
}
