//! The blocks of a linearisation, by what changes and what it changes with.

use crate::mechanics::proofs::all_vanish;
use crate::model::{Outline, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::changes::{Changes, Column};

/// What the rates of a state change by with state and input.
pub struct Linearization {
    pub accelerations: Vec<Id>,
    /// Those that are not zero, row by row.
    pub blocks: Vec<Block>,
}

/// What one group changes by with another.
pub struct Block {
    pub row: Row,
    pub column: Column,
    /// Column by column.
    pub entries: Vec<Id>,
    /// Which of them may be other than zero.
    pub is_there: Vec<bool>,
}

/// What changes: the rate of an attitude, by its number in the tangent space; or a group of
/// accelerations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Row {
    Attitude(usize),
    Acceleration(usize),
}

/// Puts together what is not zero.
pub fn assemble(
    outline: &Outline,
    work: &mut Workspace,
    accelerations: Vec<Id>,
    changes: &Changes,
    spin: impl Fn(&Workspace, usize) -> Components,
) -> Linearization {
    let mut blocks = Vec::new();
    for (number, group) in outline.tangent().iter().enumerate() {
        if group.variable == Variable::Quaternion {
            // an attitude q exp(e): e' = dw - w x e
            let w = spin(work, group.joint);
            let columns = work.graph.unit_vectors().map(|e| work.graph.cross(e, w));
            let (row, column) = (Row::Attitude(number), Column::State(number));
            blocks.extend(block(work, (row, column), columns.concat()));
        }
    }
    let all = blocks_by(outline, work, accelerations, changes);
    blocks.extend(all.blocks);
    Linearization {
        accelerations: all.accelerations,
        blocks,
    }
}

/// Puts together what accelerations change by, where that is not zero.
pub fn blocks_by(
    outline: &Outline,
    work: &mut Workspace,
    accelerations: Vec<Id>,
    changes: &Changes,
) -> Linearization {
    let (mut first, mut blocks) = (0, Vec::new());
    for (number, group) in outline.accelerations().iter().enumerate() {
        let rows = first..first + group.size;
        first = rows.end;
        for (column, changes) in changes {
            let entries = changes.iter().flat_map(|all| &all[rows.clone()]);
            let entries: Vec<Id> = entries.copied().collect();
            blocks.extend(block(work, (Row::Acceleration(number), *column), entries));
        }
    }
    Linearization {
        accelerations,
        blocks,
    }
}

/// A block, if it is not zero in all states.
fn block(work: &mut Workspace, (row, column): (Row, Column), entries: Vec<Id>) -> Option<Block> {
    let zero = work.graph.zero();
    let entries: Vec<Id> = entries
        .into_iter()
        .map(|entry| {
            if all_vanish(work, &[entry]) {
                zero
            } else {
                work.graph.result(entry)
            }
        })
        .collect();
    let is_there = entries.iter().map(|entry| !work.graph.is_zero(*entry));
    let is_there: Vec<bool> = is_there.collect();
    is_there.contains(&true).then_some(Block {
        row,
        column,
        entries,
        is_there,
    })
}
