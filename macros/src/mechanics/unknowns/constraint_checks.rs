//! Checks that the constraints determine the unknowns, the unknowns keep all constraints, and smooth
//! supports do no work, with errors at their places.

use core::fmt::Display;
use std::collections::BTreeSet;

use crate::errors::{Errors, Extent};
use crate::mechanics::proofs::{all_vanish, samples};
use crate::model::{Level, Model, Workspace};
use crate::symbolic::{Elimination, Id, Residue, Span};

use super::constrained::Constrained;
use super::pushes::{Push, free_load};
use super::unit::Unit;

/// Reports constraints that are proved to follow from others, because their reactions would not be
/// determined.
pub fn check_independent(
    work: &mut Workspace,
    constraints: &[Constrained],
    errors: &mut Errors,
) -> Option<()> {
    let roots: Vec<Id> = constraints
        .iter()
        .flat_map(|constraint| constraint.rates.factors.entries())
        .collect();
    let samples = samples(work, &roots);
    let branches = samples.first().map_or(0, |sample| sample.0.len());
    let gradients = |branch: usize| -> Vec<Option<Vec<Residue>>> {
        let rows = samples.chunks(6);
        rows.map(|row| row.iter().map(|sample| sample.0[branch]).collect())
            .collect()
    };
    let redundant: Vec<Vec<Option<Vec<usize>>>> = (0..branches)
        .map(|branch| redundant(&gradients(branch)))
        .collect();
    let mut independent = true;
    for (index, constraint) in constraints.iter().enumerate() {
        // it must follow from the others on every branch
        let of: Option<Vec<&Vec<usize>>> = redundant
            .iter()
            .map(|branch| branch[index].as_ref())
            .collect();
        let Some(of) = of else {
            continue;
        };
        let others: BTreeSet<usize> = of.into_iter().flatten().copied().collect();
        let message = if others.is_empty() {
            trivial(&constraint.name, constraint.level())
        } else {
            let others = others.into_iter().map(|other| &constraints[other].name);
            dependent(&constraint.name, others)
        };
        errors.push(constraint.place.span(), message);
        independent = false;
    }
    independent.then_some(())
}

/// The error for a constraint that no acceleration changes.
pub fn trivial(name: impl Display, level: Level) -> String {
    let why = match level {
        Level::Position => ":",
        Level::Velocity => ": its velocities cancel, or only conditions have them;",
    };
    format!("no acceleration changes `{name}`{why} no load can keep it at zero")
}

/// The error for a constraint whose gradient follows from those of these others: it follows from
/// them itself, or contradicts them.
pub fn dependent(name: impl Display, others: impl IntoIterator<Item = impl Display>) -> String {
    let others = others.into_iter().map(|other| format!("`{other}`"));
    let others: Vec<String> = others.collect();
    let others = others.join(" and ");
    format!("`{name}` restrains the same motion as {others}: leave one of them out")
}

/// The error for a constraint that changes where no acceleration changes it.
pub fn lost(name: impl Display, level: Level) -> String {
    match level {
        Level::Position => {
            format!(
                "on some branches `{name}` changes by itself: no load can keep it at zero there"
            )
        }
        Level::Velocity => format!(
            "`{name}` has velocities on some branches only: no load can keep it at zero on the others"
        ),
    }
}

/// For each gradient on one branch, the others that it follows from. `None` if it is independent or
/// has no value.
fn redundant(gradients: &[Option<Vec<Residue>>]) -> Vec<Option<Vec<usize>>> {
    let mut span = Span::default();
    let gradients = gradients.iter().enumerate();
    let redundant = gradients.map(|(index, gradient)| span.admit(index, gradient.as_ref()?));
    redundant.collect()
}

/// Reports unknowns that keep no constraint while a constraint is left, each pair as one mistake, and
/// takes them out of the elimination.
pub fn check_misplaced(
    work: &Workspace,
    constraints: &[Constrained],
    unknowns: &[(String, Extent)],
    elimination: &mut Elimination,
    errors: &mut Errors,
) -> Option<()> {
    let rows = elimination.spare.iter().map(|(row, _)| *row);
    let mut left: Vec<usize> = rows.filter(|row| *row < constraints.len()).collect();
    left.truncate(elimination.undetermined.len());
    for (row, unknown) in left
        .iter()
        .zip(elimination.undetermined.drain(..left.len()))
    {
        let constraint = &constraints[*row];
        let (name, place) = &unknowns[unknown.column];
        let others = unknown.others.iter().map(|other| &*unknowns[*other].0);
        let others = others.collect::<Vec<_>>().join("` and `");
        let what = if others.is_empty() {
            format!("`{name}` acts against no constraint")
        } else {
            format!("`{others}` can replace `{name}`")
        };
        let advice = match smooth_support(work, constraint) {
            none if none.is_empty() => {
                ": mark a component with `_` that acts against that".to_owned()
            }
            advice => advice,
        };
        let kept = &constraint.name;
        errors.push(
            *place,
            format!("{what}, and nothing keeps `{kept}`{advice}"),
        );
    }
    elimination.spare.retain(|(row, _)| !left.contains(row));
    left.is_empty().then_some(())
}

/// Reports constraints that no unknown keeps, and remaining balances that are not satisfied.
pub fn check_kept(
    model: &Model,
    work: &Workspace,
    constraints: &[Constrained],
    left: &[&str],
    pushes: &[Push<'_>],
    elimination: &Elimination,
    errors: &mut Errors,
) -> Option<()> {
    let turned = turned(model, pushes);
    for (row, _) in &elimination.spare {
        if let Some(constraint) = constraints.get(*row).filter(|_| turned.is_none()) {
            errors.push(
                constraint.place.span(),
                format!(
                    "no unknown reaction keeps `{}`: mark a component that acts against it with `_` \
                     in `reactions`{}",
                    constraint.name,
                    smooth_support(work, constraint)
                ),
            );
        } else if let Some(push) = pushes.iter().find(|push| push.supports) {
            let balance = left[*row - constraints.len()];
            errors.push(
                push.unit.place,
                format!(
                    "nothing balances {balance}: leave another component of a reaction unknown"
                ),
            );
        } else if let Some(push) = turned.or(pushes.first()) {
            errors.push(
                push.unit.place,
                format!(
                    "under `motion: {}` nothing balances the moment of the reactions: let them act \
                     at G, or leave a moment in `reactions` unknown",
                    model.motion.word
                ),
            );
        }
    }
    elimination.spare.is_empty().then_some(())
}

/// The first unknown that would rotate a body that does not rotate.
pub fn turned<'p, 'm>(model: &Model, pushes: &'p [Push<'m>]) -> Option<&'p Push<'m>> {
    let is_turned = |push: &&Push<'_>| !model.motion.has_attitude() && !push.unit.moment.is_zero();
    pushes.iter().find(is_turned)
}

/// Reports a reaction with the gradient of a constraint in its direction, if it is not proved to be
/// along the whole gradient, of which a force has the linear part, and its arm the angular part.
pub fn check_smooth(
    model: &Model,
    work: &mut Workspace,
    constraints: &[Constrained],
    pushes: &[Push<'_>],
    errors: &mut Errors,
) -> Option<()> {
    let mut all = Some(());
    for push in pushes {
        let Unit {
            load, axis, place, ..
        } = push.unit;
        let is_it = |constraint: &&Constrained| Some(&constraint.name) == load.gradient_of.as_ref();
        let Some(constraint) = constraints.iter().find(is_it) else {
            continue;
        };
        let unit = Unit::new(model, work, load, load.frame, (axis, place), &[]);
        let load = free_load(model, work, &unit).entries();
        if !are_parallel(work, &load, &constraint.rates.factors.entries()) {
            let name = &constraint.name;
            errors.push(
                place,
                format!(
                    "this is not along the gradient of `{name}`, and would do work: a smooth support is \
                     `(_ * {name}.gradient()).at(P)`, at the point P that `{name}` holds"
                ),
            );
            all = None;
        }
    }
    all
}

/// Whether one is proved to be a multiple of the other.
fn are_parallel(work: &mut Workspace, a: &[Id], b: &[Id]) -> bool {
    let mut minors = Vec::new();
    for i in 0..a.len() {
        for j in 0..i {
            let graph = &mut work.graph;
            let [left, right] = [(i, j), (j, i)].map(|(i, j)| graph.multiply(a[i], b[j]));
            minors.push(graph.subtract(left, right));
        }
    }
    all_vanish(work, &minors)
}

/// How the smooth support of a constraint is written, as the end of a message. Empty for a
/// constraint of velocities, which is kept by friction, and for one that only moments keep.
pub fn smooth_support(work: &Workspace, constraint: &Constrained) -> String {
    let along_position = constraint.rates.factors.linear;
    let is_turning = along_position.iter().all(|part| work.graph.is_zero(*part));
    if constraint.position.is_none() || is_turning {
        return String::new();
    }
    format!(
        "; a smooth support is `(_ * {}.gradient()).at(P)`, at the point P that it holds",
        constraint.name
    )
}
