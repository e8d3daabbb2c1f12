//! Accelerations, solved for block by block.

use crate::model::Workspace;
use crate::symbolic::{Elimination, Id, Size};

use super::balances::{Balance, Balances, LinearRow, at};
use super::block::Block;
use super::equations::{LoadedRow, label, together};

/// The solution of balances and rows.
pub struct Reduced {
    /// The accelerations of all coordinates: the original ones, followed by those that stand for
    /// others.
    pub values: Vec<Id>,
    pub blocks: Vec<Block>,
    /// The rows that were eliminated together with the balances, each with its load.
    pub eliminated: Vec<(usize, Id)>,
}

/// Solves `M x = f + A^T l`, `A x = r` for x. `None` if rows turn out to be dependent.
pub fn reduce(
    work: &mut Workspace,
    balances: Vec<Balance>,
    rows: Vec<LinearRow>,
) -> Option<Reduced> {
    let mut balances = Balances::new(work, balances, rows);
    while balances.next_block() {}
    finish(balances)
}

/// Eliminates what remains. From that, the values of all coordinates follow, in reverse order.
fn finish(mut balances: Balances<'_>) -> Option<Reduced> {
    let zero = balances.work.graph.zero();
    let mut values = vec![zero; balances.all.len()];
    let left = balances.left();
    let open = (0..balances.all.len()).filter(|own| balances.open[*own]);
    let (alone, open): (Vec<usize>, Vec<usize>) =
        open.partition(|own| is_alone(&balances, *own, &left));
    let solved = eliminate(&mut balances, &open, &left);
    if !solved.undetermined.is_empty() {
        return None;
    }
    let mut found = solved.values.into_iter();
    for (own, value) in open.iter().zip(&mut found) {
        values[*own] = value;
    }
    for block in balances.blocks.iter().rev() {
        let Some(way) = &block.way else {
            for (own, value) in block.coordinates.iter().zip(&block.fixed) {
                values[*own] = *value;
            }
            continue;
        };
        // a coordinate that moves alone is divided once, together with those that it stands for
        let is_alone = alone.contains(&way.coordinate);
        let (parts, by) = if is_alone {
            (&way.numerators, balances.all[way.coordinate].driving)
        } else {
            let own = values[way.coordinate];
            let name = &balances.all[way.coordinate].name;
            balances
                .work
                .labels
                .name(own, format!("acceleration_{name}"));
            (&block.fixed, own)
        };
        let graph = &mut balances.work.graph;
        let by = graph.quantity(by);
        for ((own, part), along) in block.coordinates.iter().zip(parts).zip(&way.along) {
            let moved = graph.multiply(by, *along);
            let mut value = graph.add(*part, moved);
            if is_alone {
                value = graph.multiply(block.inverse, value);
            }
            values[*own] = graph.quantity(value);
        }
    }
    Some(Reduced {
        values,
        blocks: balances.blocks,
        eliminated: left.into_iter().zip(found).collect(),
    })
}

/// Whether a coordinate stands for others and is not coupled to any other remaining coordinate or
/// row.
fn is_alone(balances: &Balances<'_>, own: usize, left: &[usize]) -> bool {
    let graph = &balances.work.graph;
    let mut ways = balances
        .blocks
        .iter()
        .filter_map(|block| block.way.as_ref());
    let mut others = (0..balances.all.len()).filter(|other| balances.open[*other] && *other != own);
    ways.any(|way| way.coordinate == own)
        && others.all(|other| graph.is_zero(balances.all[own].masses[other]))
        && left
            .iter()
            .all(|row| graph.is_zero(balances.rows[*row].slopes[own]))
}

/// Eliminates the remaining balances and rows together.
fn eliminate(balances: &mut Balances<'_>, open: &[usize], left: &[usize]) -> Elimination {
    let own = open.iter().map(|own| &balances.all[*own]);
    let masses = own.clone().map(|one| at(&one.masses, open).collect());
    let masses: Vec<Vec<Id>> = masses.collect();
    let driving: Vec<Id> = own.map(|one| one.driving).collect();
    let zero = balances.work.graph.zero();
    let rows = left.iter().map(|row| {
        let row = &balances.rows[*row];
        let slopes: Vec<Id> = at(&row.slopes, open).collect();
        LoadedRow {
            pushes: slopes.clone(),
            slopes,
            right: row.right,
            own: zero,
        }
    });
    let rows: Vec<LoadedRow> = rows.collect();
    let equations = together(balances.work, (&masses, &driving), &rows, Size::Reduced);
    let unknowns = open.len() + left.len();
    let solved = balances.work.graph.solve(equations, unknowns);
    let coordinates = open.iter().map(|own| &balances.all[*own].name);
    let rows = left.iter().map(|row| &balances.rows[*row].name);
    let names: Vec<String> = coordinates.chain(rows).cloned().collect();
    label(&mut balances.work.labels, &solved, &names);
    solved
}
