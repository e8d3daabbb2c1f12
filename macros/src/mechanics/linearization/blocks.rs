//! The blocks of a linearization, one for each group of rows and group of columns.

use crate::mechanics::proofs::vanishing;
use crate::model::{Outline, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::changes::{Changes, Column};

/// The derivatives of the rates of a state with respect to state and input.
pub struct Linearization {
    pub accelerations: Vec<Id>,
    /// The nonzero blocks, row by row.
    pub blocks: Vec<Block>,
}

/// The derivatives of one group with respect to another.
pub struct Block {
    pub row: Row,
    pub column: Column,
    /// The entries, column by column.
    pub entries: Vec<Id>,
    /// Whether each entry may be nonzero.
    pub is_there: Vec<bool>,
}

/// A group of rows: the rate of an attitude, by its index in the tangent space, or a group of
/// accelerations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Row {
    Attitude(usize),
    Acceleration(usize),
}

/// Assembles the nonzero blocks.
pub fn assemble(
    outline: &Outline,
    work: &mut Workspace,
    accelerations: Vec<Id>,
    changes: &Changes,
    spin: impl Fn(&Workspace, usize) -> Components,
) -> Linearization {
    let mut written = Vec::new();
    for (number, group) in outline.tangent().iter().enumerate() {
        if group.variable == Variable::Quaternion {
            // for an attitude q exp(e): e' = dw - w x e
            let w = spin(work, group.joint);
            let columns = work.graph.unit_vectors().map(|e| work.graph.cross(e, w));
            let (row, column) = (Row::Attitude(number), Column::State(number));
            written.push((row, column, columns.concat()));
        }
    }
    written.extend(by_accelerations(outline, changes));
    Linearization {
        accelerations,
        blocks: not_zero(work, written),
    }
}

/// Assembles the nonzero derivatives of accelerations.
pub fn blocks_by(
    outline: &Outline,
    work: &mut Workspace,
    accelerations: Vec<Id>,
    changes: &Changes,
) -> Linearization {
    Linearization {
        accelerations,
        blocks: not_zero(work, by_accelerations(outline, changes)),
    }
}

/// The group of rows, the group of columns, and the entries of a block.
type Written = (Row, Column, Vec<Id>);

fn by_accelerations(outline: &Outline, changes: &Changes) -> Vec<Written> {
    let (mut first, mut written) = (0, Vec::new());
    for (number, group) in outline.accelerations().iter().enumerate() {
        let rows = first..first + group.size;
        first = rows.end;
        for (column, changes) in changes {
            let entries = changes.iter().flat_map(|all| &all[rows.clone()]);
            let entries: Vec<Id> = entries.copied().collect();
            written.push((Row::Acceleration(number), *column, entries));
        }
    }
    written
}

/// The blocks that are not zero in all states.
fn not_zero(work: &mut Workspace, written: Vec<Written>) -> Vec<Block> {
    let zero = work.graph.zero();
    let all = written.iter().flat_map(|(.., entries)| entries);
    let all: Vec<Id> = all.copied().collect();
    let mut vanishing = vanishing(work, &all).into_iter();
    let blocks = written.into_iter().map(|(row, column, mut entries)| {
        for (entry, is_zero) in entries.iter_mut().zip(vanishing.by_ref()) {
            *entry = if is_zero {
                zero
            } else {
                work.graph.result(*entry)
            };
        }
        let is_there = entries.iter().map(|entry| !work.graph.is_zero(*entry));
        Block {
            row,
            column,
            is_there: is_there.collect(),
            entries,
        }
    });
    let blocks: Vec<Block> = blocks.collect();
    let is_there = |block: &Block| block.is_there.contains(&true);
    blocks.into_iter().filter(is_there).collect()
}
