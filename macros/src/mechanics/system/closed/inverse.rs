//! Inverse dynamics of a system held by more than its tree: the open drives u and the constraint
//! loads l that together are the loads that the joints need,
//!
//! ```text
//! u + A^T l = M q'' - f
//! ```

use crate::mechanics::unknowns::equations;
use crate::model::Workspace;
use crate::symbolic::{Elimination, Id};

use super::super::constraints::split;
use super::solve::Closed;

/// Solves for the open drives, and then for the loads. `needed` is the right side along each open
/// coordinate, in which `symbols` are the loads of written constraints; `open` are the coordinates
/// that have an open drive.
pub fn solve_drives(
    work: &mut Workspace,
    closed: &Closed,
    (needed, symbols): (&[Id], &[Id]),
    open: &[usize],
) -> Elimination {
    let (needed, following) = split(&mut work.graph, needed, symbols);
    let (zero, one) = (work.graph.zero(), work.graph.one());
    let mut sides = Vec::new();
    for (freedom, needed) in needed.into_iter().enumerate() {
        let mut coefficients: Vec<Id> = open
            .iter()
            .map(|other| if *other == freedom { one } else { zero })
            .collect();
        for ((owner, row), follows) in closed.kept.iter().zip(&closed.follows) {
            let slope = if *follows { zero } else { row.slopes[freedom] };
            let number = owner.number();
            let back = number.map_or(zero, |number| following[number][freedom]);
            coefficients.push(work.graph.subtract(slope, back));
        }
        sides.push((coefficients, needed));
    }
    for (number, row) in closed.rows().enumerate() {
        if row.activity.condition.is_some() {
            let mut coefficients = vec![zero; open.len() + closed.kept.len()];
            coefficients[open.len() + number] = row.triviality(&mut work.graph);
            sides.push((coefficients, zero));
        }
    }
    let equations = equations(work, sides);
    let unknowns = open.len() + closed.kept.len();
    work.graph.solve(equations, unknowns)
}
