//! Derivatives of accelerations by parameters. Nothing moves, so the chain rule passes through
//! rotations as through everything else, and through expressions of parameters alone.

use crate::mechanics::system::{Response, SystemEquations};
use crate::model::{Meaning, Model, Outline, Pair, System, Workspace};
use crate::symbolic::Id;

use super::blocks::{Linearization, blocks_by};
use super::body::in_order;
use super::changes::{Changes, Column};
use super::system::changing;

pub fn sensitivity_of_body(
    outline: &Outline,
    model: &Model,
    work: &mut Workspace,
    pair: Pair,
) -> Linearization {
    let accelerations = in_order(model, pair);
    let changes = by_params(outline, work, |work, symbol| {
        changed(work, &accelerations, symbol)
    });
    blocks_by(outline, work, accelerations, &changes)
}

/// For a tree the balances are differentiated; for a system held by more than a tree, the
/// accelerations.
pub fn sensitivity_of_system(
    outline: &Outline,
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Linearization {
    let mut response = Response::of(system, work, equations);
    let (accelerations, changing) = changing(system, equations, response.as_ref());
    let changes = by_params(outline, work, |work, symbol| match &mut response {
        Some(response) => {
            let change = changed(work, &changing, symbol);
            let (change, rates) = change.split_at(change.len() - system.states.len());
            [response.to(work, change).as_slice(), rates].concat()
        }
        None => changed(work, &changing, symbol),
    });
    blocks_by(outline, work, accelerations, &changes)
}

fn changed(work: &mut Workspace, roots: &[Id], symbol: Id) -> Vec<Id> {
    let one = work.graph.one();
    work.graph.change(roots, |id| (id == symbol).then_some(one))
}

/// The changes with each component of each parameter.
fn by_params(
    outline: &Outline,
    work: &mut Workspace,
    mut change: impl FnMut(&mut Workspace, Id) -> Vec<Id>,
) -> Changes {
    let params = (0..outline.params.len()).map(|number| {
        let parts = [None, Some(0), Some(1), Some(2)].into_iter();
        let symbols = parts.filter_map(|part| work.symbol_of(Meaning::Param(number, part)));
        let symbols: Vec<Id> = symbols.collect();
        let changes = symbols.into_iter().map(|symbol| change(work, symbol));
        (Column::Param(number), changes.collect())
    });
    params.collect()
}
