//! Which rows depend on others, on each branch of the constraints.

use crate::mechanics::system::constraints::ConstraintRow;
use crate::mechanics::tree::MassMatrix;
use crate::model::{System, Workspace};
use crate::symbolic::{Graph, Id};

use super::assembly::{Assembly, Coordinates, Rank};

/// The most conditions in constraints that are decided, one inside the other or side by side.
const MOST_CONDITIONS: usize = 31;

/// Which rows depend on others on all branches: one that is independent on a branch is needed.
/// Where rows are independent, `some` selects those that are to determine the motion, with the
/// masses. The last rows, `written` many, are the ones with branches: the conditions of joints choose
/// between forms of one expression. If there are too many branches, they are pieces of one.
pub fn rank(
    system: &System,
    work: &mut Workspace,
    (rows, written, coordinates): (&[ConstraintRow], usize, &Coordinates),
    matrix: &MassMatrix,
    some: &Selection<'_>,
) -> Rank {
    let smooth = rows.len() - written;
    let parts: Vec<Id> = parts(&rows[smooth..]).collect();
    let parts = work.graph.in_pieces(&parts);
    let rows = with_written(rows, smooth, parts);
    let mut ranks = Ranks {
        system,
        work,
        coordinates,
        matrix,
        some,
        smooth,
        left: MOST_CONDITIONS,
    };
    ranks.of(&rows)
}

fn parts(rows: &[ConstraintRow]) -> impl Iterator<Item = Id> {
    rows.iter().flat_map(ConstraintRow::parts)
}

/// The rows, of which those after the smooth ones have these parts.
fn with_written(rows: &[ConstraintRow], smooth: usize, parts: Vec<Id>) -> Vec<ConstraintRow> {
    let mut parts = parts.into_iter();
    let (smooth, written) = rows.split_at(smooth);
    let written = written.iter().map(|row| row.with_parts(&mut parts));
    smooth.iter().cloned().chain(written).collect()
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
    fn of(&mut self, rows: &[ConstraintRow]) -> Rank {
        let parts: Vec<Id> = parts(&rows[self.smooth..]).collect();
        let condition = self.work.graph.outermost_condition(&parts);
        let Some(condition) = condition.filter(|_| self.left > 0) else {
            return self.together(rows);
        };
        self.left -= 1;
        let [there, elsewhere] = [true, false].map(|holds| {
            let side = self.work.graph.on_side(&parts, condition, holds);
            self.of(&with_written(rows, self.smooth, side))
        });
        there.or(elsewhere)
    }

    fn together(&mut self, rows: &[ConstraintRow]) -> Rank {
        let slopes: Vec<Id> = rows.iter().flat_map(|row| row.slopes.clone()).collect();
        let graph = &mut self.work.graph;
        let terms = graph.magnitudes(&slopes);
        let are_pieces = rows.iter().enumerate().map(|(number, row)| {
            number >= self.smooth && graph.has_pieces(&row.parts().collect::<Vec<Id>>())
        });
        let are_pieces: Vec<bool> = are_pieces.collect();
        let (work, rows) = (&*self.work, (rows.iter().collect(), &terms[..]));
        let assembly = Assembly::new(self.system, work, self.coordinates, rows);
        let some = |closed: &[bool]| (self.some)(&work.graph, closed);
        assembly.rank(self.matrix, some, &are_pieces)
    }
}
