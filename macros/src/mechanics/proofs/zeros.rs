//! Expressions proved to be zero in all states, by their values at one random state.

use crate::model::Workspace;
use crate::symbolic::{Id, Sample};

use super::random_state::RandomState;

/// Whether all of `roots` are proved to be zero in all states, on all branches.
pub fn all_vanish(work: &Workspace, roots: &[Id]) -> bool {
    let told = decided_at_once(work, roots);
    !told.contains(&Some(false)) && {
        let left = left_over(roots, &told);
        samples(work, &left).iter().all(Sample::is_zero)
    }
}

/// Whether each of `roots` is proved to be zero in all states. They are tested together, or
/// separately if residues cannot decide one of them.
pub fn vanishing(work: &Workspace, roots: &[Id]) -> Vec<bool> {
    let told = decided_at_once(work, roots);
    let left = left_over(roots, &told);
    let samples = samples(work, &left);
    let tried = samples.iter().zip(left).map(|(sample, root)| {
        sample.is_zero() || !sample.is_refuted() && all_vanish(work, &[root])
    });
    let mut tried = tried.collect::<Vec<bool>>().into_iter();
    let all = told.into_iter();
    all.map(|told| told.or_else(|| tried.next()) == Some(true))
        .collect()
}

/// Whether each of `roots` is zero, where few evaluations tell.
fn decided_at_once(work: &Workspace, roots: &[Id]) -> Vec<Option<bool>> {
    let state = RandomState::draw(0);
    work.graph.decided_at_once(roots, |id| state.of(work, id))
}

/// Those of `roots` for which all branches are to be tried.
fn left_over(roots: &[Id], told: &[Option<bool>]) -> Vec<Id> {
    let left = roots.iter().zip(told).filter(|(_, told)| told.is_none());
    left.map(|(root, _)| *root).collect()
}

/// The values of `roots` at one random state, on each branch.
pub fn samples(work: &Workspace, roots: &[Id]) -> Vec<Sample> {
    let state = RandomState::draw(0);
    work.graph.samples(roots, |id| state.of(work, id))
}

/// Whether an expression may be zero everywhere on some branch, or on a piece of a function.
pub fn may_vanish(work: &Workspace, root: Id) -> bool {
    let state = RandomState::draw(0);
    work.graph.may_vanish(root, |id| state.of(work, id))
}

/// Whether the sums of `roots` over an attitude and its half turns about the body axes are proved
/// to be zero. The entries of the rotation matrix have this property, and so has everything linear
/// in them.
pub fn cancels_in_half_turns(work: &Workspace, roots: &[Id]) -> bool {
    let states = [None, Some(0), Some(1), Some(2)].map(|axis| RandomState::draw(0).turned(axis));
    let places = states.each_ref().map(|state| |id| state.of(work, id));
    let sums = work.graph.sums(roots, &places);
    sums.iter().all(Sample::is_zero)
}
