//! Equations that are dependent but consistent: `S l = r`.

use crate::symbolic::{Graph, Id};

/// Equations whose matrix has no negative eigenvalue, solved group by group; each group has a
/// number of rows and a rank.
pub struct Solver {
    pub steps: Vec<Step>,
}

pub struct Step {
    pub own: std::ops::Range<usize>,
    /// `N_k / e_k` of these rows, once the earlier rows are eliminated.
    inverse: Vec<Vec<Id>>,
    /// The coefficients of these loads in later rows, which are also those of later loads in these
    /// rows.
    later: Vec<Vec<Id>>,
    /// A positive value.
    pub size: Id,
}

impl Solver {
    pub fn new(
        graph: &mut Graph,
        (matrix, bounds): (&[Vec<Id>], &[Id]),
        ranks: &[(usize, usize)],
    ) -> Self {
        let mut matrix = matrix.to_vec();
        let (mut first, mut steps) = (0, Vec::new());
        for (count, rank) in ranks {
            let own = first..first + count;
            first = own.end;
            let block: Vec<Vec<Id>> = own
                .clone()
                .map(|row| matrix[row][own.clone()].to_vec())
                .collect();
            let size = graph.sum(&bounds[own.clone()]);
            let size = graph.quantity(size);
            let inverse = inverse(graph, &block, *rank, size);
            let later: Vec<Vec<Id>> = (first..matrix.len())
                .map(|row| matrix[row][own.clone()].to_vec())
                .collect();
            for (row, factors) in (first..matrix.len()).zip(&later) {
                let taken = of_matrix(graph, &inverse, factors);
                for column in first..matrix.len() {
                    let less = graph.inner(&taken, &later[column - first]);
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

    pub fn solve(&self, graph: &mut Graph, right: &[Id]) -> Vec<Id> {
        let mut right = right.to_vec();
        for step in &self.steps {
            let known = of_matrix(graph, &step.inverse, &right[step.own.clone()]);
            for (row, factors) in step.later.iter().enumerate() {
                let less = graph.inner(factors, &known);
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
                    let less = graph.inner(&slopes, &values[step.own.end..]);
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

/// `N_k / e_k`, where `size` is the size of the eigenvalues.
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
                    .map(|other| graph.inner(&block[own], &column(other)))
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
    let all = matrix.iter().map(|row| graph.inner(row, vector));
    all.collect()
}
