//! Which rows depend on others, on each branch of the constraints.

use crate::mechanics::tree::MassMatrix;
use crate::model::{System, Workspace};
use crate::symbolic::{Graph, Id};

use super::super::super::constraints::ConstraintRow;
use super::assembly::{Assembly, Coordinates, Rank};

/// The most conditions in constraints that are decided, one inside the other or side by side.
const MOST_CONDITIONS: usize = 31;

/// Which rows depend on others on all branches: one that is independent on a branch is needed.
/// Where rows are independent, `some` selects those that are to determine the motion, with the
/// masses. The last rows, `written` many, are the ones with branches: the conditions of joints choose
/// between forms of one expression. Nothing is known if there are too many branches.
pub fn rank(
    system: &System,
    work: &mut Workspace,
    (rows, written, coordinates): (&[ConstraintRow], usize, &Coordinates),
    matrix: &MassMatrix,
    some: &Selection<'_>,
) -> Rank {
    let mut ranks = Ranks {
        system,
        work,
        coordinates,
        matrix,
        some,
        smooth: rows.len() - written,
        left: MOST_CONDITIONS,
    };
    ranks.of(rows).unwrap_or_default()
}

type Selection<'s> = dyn Fn(&Graph, &[bool]) -> Vec<usize> + 's;

struct Ranks<'r> {
    system: &'r System,
    work: &'r mut Workspace,
    coordinates: &'r Coordinates,
    matrix: &'r MassMatrix,
    some: &'r Selection<'r>,
    /// The number of rows without branches, which come first.
    smooth: usize,
    /// How many conditions may still be decided.
    left: usize,
}

impl Ranks<'_> {
    fn of(&mut self, rows: &[ConstraintRow]) -> Option<Rank> {
        let (smooth, written) = rows.split_at(self.smooth);
        let parts = written.iter().flat_map(ConstraintRow::parts);
        let graph = &mut self.work.graph;
        let parts = graph.in_pieces(&parts.collect::<Vec<Id>>());
        let Some(condition) = graph.outermost_condition(&parts) else {
            return Some(self.on_one_branch(rows));
        };
        self.left = self.left.checked_sub(1)?;
        let [there, elsewhere] = [true, false].map(|holds| {
            let side = self.work.graph.on_side(&parts, condition, holds);
            let mut side = side.into_iter();
            let written = written.iter().map(|row| row.with_parts(&mut side));
            let rows = smooth.iter().cloned().chain(written);
            self.of(&rows.collect::<Vec<ConstraintRow>>())
        });
        Some(there?.or(elsewhere?))
    }

    fn on_one_branch(&mut self, rows: &[ConstraintRow]) -> Rank {
        let slopes: Vec<Id> = rows.iter().flat_map(|row| row.slopes.clone()).collect();
        let terms = self.work.graph.magnitudes(&slopes);
        let (work, rows) = (&*self.work, (rows.iter().collect(), &terms[..]));
        let assembly = Assembly::new(self.system, work, self.coordinates, rows);
        assembly.rank(self.matrix, |closed| (self.some)(&work.graph, closed))
    }
}
