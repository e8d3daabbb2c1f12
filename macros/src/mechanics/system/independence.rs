//! Joints with massless bodies between them. They must move bodies with mass in independent ways.

use std::collections::BTreeSet;

use crate::errors::Errors;
use crate::mechanics::proofs::samples;
use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::{Built, MassMatrix};
use crate::model::{Labels, System, Workspace};
use crate::symbolic::{Id, Sample};

/// Reports joints of a tree whose motion other joints can undo, so that no mass moves: then the
/// mass matrix is singular in all states.
pub fn check_independence(
    system: &System,
    work: &mut Workspace,
    (built, tree): (&Built, &Tree),
    errors: &mut Errors,
) -> Option<()> {
    let mut links = tree.links.iter();
    if links.all(|link| !work.graph.is_zero(link.properties.mass)) {
        return Some(());
    }
    let matrix = MassMatrix::derive(&mut work.graph, &mut Labels::silent(), tree);
    let mut sound = Some(());
    let found = dependent(work, &matrix.rows).into_iter();
    let joints: BTreeSet<usize> = found
        .filter_map(|freedom| joint_of(built, freedom))
        .collect();
    for joint in joints {
        let carried = &system.bodies[joint];
        let message = if work.graph.is_zero(carried.mass) {
            format!(
                "`{0}` adds no independent motion: `{1}` has no mass, and the joints that it carries can undo the \
                 motion: give `{1}` a mass, or leave one of these joints out",
                system.joints[joint].name, carried.name
            )
        } else {
            format!(
                "the freedoms of `{}` do not move `{}` in independent ways",
                system.joints[joint].name, carried.name
            )
        };
        sound = errors.report(system.joints[joint].written, message);
    }
    sound
}

/// The freedoms that have no inertia in a matrix once the later ones are free, which is proved in
/// all states.
fn dependent(work: &Workspace, rows: &[Vec<Id>]) -> Vec<usize> {
    let all = samples(work, &rows.concat());
    let mut left: Vec<Vec<Sample>> = all
        .chunks(rows.len().max(1))
        .map(<[Sample]>::to_vec)
        .collect();
    let mut found = Vec::new();
    for k in (0..rows.len()).rev() {
        let pivot = left[k][k].clone();
        if pivot.is_zero() {
            found.push(k);
            continue;
        }
        let row = left[k].clone();
        for own in &mut left[..k] {
            let share = own[k].over(&pivot);
            for (entry, other) in own[..k].iter_mut().zip(&row) {
                *entry = entry.minus(&share.times(other));
            }
        }
    }
    found
}

/// The joint that a freedom belongs to.
fn joint_of(built: &Built, freedom: usize) -> Option<usize> {
    let mut next = 0;
    built.links.iter().position(|links| {
        let links = &built.tree.links[links.clone()];
        next += links.iter().map(|link| link.open().count()).sum::<usize>();
        freedom < next
    })
}
