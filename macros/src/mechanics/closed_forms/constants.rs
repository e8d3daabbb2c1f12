//! Expressions that are the same in all states.

use crate::mechanics::proofs::all_vanish;
use crate::model::{Meaning, Variable, Workspace};
use crate::symbolic::Id;

/// The values of expressions, known early, if the expressions are proved to be the same in all
/// states.
pub fn constants(work: &mut Workspace, roots: &[Id]) -> Option<Vec<Id>> {
    if work.graph.are_early(roots) {
        return Some(roots.to_vec());
    }
    let values = at_rest(work, roots, |_| false);
    if !work.graph.are_early(&values) {
        return None;
    }
    let pairs = roots.iter().zip(&values);
    let differences: Vec<Id> = pairs
        .map(|(root, value)| work.graph.subtract(*root, *value))
        .collect();
    all_vanish(work, &differences).then_some(values)
}

/// Expressions in the state in which all attitudes are those of the ground, and all other numbers
/// are zero, except those that are `kept`.
pub fn at_rest(work: &mut Workspace, roots: &[Id], kept: impl Fn(Id) -> bool) -> Vec<Id> {
    let (zero, one) = (work.graph.zero(), work.graph.one());
    let late = work.graph.reachable(roots, &|id| !work.graph.is_early(id));
    let values = late.into_iter().filter_map(|id| match work.meaning(id)? {
        _ if work.graph.is_early(id) || kept(id) => None,
        Meaning::Of(_, Variable::Quaternion, 0) => Some((id, one)),
        _ => Some((id, zero)),
    });
    let values: Vec<(Id, Id)> = values.collect();
    work.graph.substitute(roots, |id| {
        let known = values.iter().find(|(symbol, _)| *symbol == id);
        known.map(|(_, value)| *value)
    })
}
