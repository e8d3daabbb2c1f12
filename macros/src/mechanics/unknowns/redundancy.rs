//! Checks that the constraints determine the unknowns and the unknowns keep all constraints, with
//! errors at their places.

use std::collections::BTreeSet;

use crate::errors::Errors;
use crate::mechanics::proofs::samples;
use crate::model::{Model, Workspace};
use crate::symbolic::{Elimination, Id, Residue};

use super::constrained::Constrained;
use super::pushes::Push;

/// The gradient of a constraint on one branch, with its parts along earlier gradients removed.
struct Reduced {
    index: usize,
    lead: usize,
    gradient: Vec<Residue>,
    /// The constraints in this combination.
    of: Vec<usize>,
}

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
        let others: Vec<String> = others
            .into_iter()
            .map(|other| format!("`{}`", constraints[other].name))
            .collect();
        let name = &constraint.name;
        let message = if others.is_empty() {
            format!("no acceleration changes `{name}`: no load can keep it at zero")
        } else {
            let others = others.join(" and ");
            format!("`{name}` is kept already by {others}: leave one of them out")
        };
        errors.push(constraint.place.span(), message);
        independent = false;
    }
    independent.then_some(())
}

/// For each gradient on one branch, the others that it follows from. `None` if it is independent or
/// has no value.
fn redundant(gradients: &[Option<Vec<Residue>>]) -> Vec<Option<Vec<usize>>> {
    let mut basis: Vec<Reduced> = Vec::new();
    let redundant = gradients.iter().enumerate().map(|(index, gradient)| {
        let (gradient, mut of) = reduce(gradient.clone()?, &basis);
        let Some(lead) = gradient.iter().position(|entry| !entry.is_zero()) else {
            return Some(of);
        };
        of.push(index);
        basis.push(Reduced {
            index,
            lead,
            gradient,
            of,
        });
        None
    });
    redundant.collect()
}

/// A gradient without its parts along `basis`, and the constraints that these parts belong to.
fn reduce(mut gradient: Vec<Residue>, basis: &[Reduced]) -> (Vec<Residue>, Vec<usize>) {
    let mut of = Vec::new();
    for known in basis {
        let lead = known.gradient[known.lead];
        if gradient[known.lead].is_zero() {
            continue;
        }
        let factor = -(gradient[known.lead] * lead.reciprocal().unwrap_or(Residue::ZERO));
        for (entry, part) in gradient.iter_mut().zip(&known.gradient) {
            *entry = *entry + factor * *part;
        }
        of.extend(known.of.iter().copied());
        of.push(known.index);
    }
    of.sort_unstable();
    of.dedup();
    (gradient, of)
}

/// Reports constraints that no unknown keeps, and remaining balances that are not satisfied.
pub fn check_kept(
    model: &Model,
    constraints: &[Constrained],
    left: &[&str],
    pushes: &[Push<'_>],
    elimination: &Elimination,
    errors: &mut Errors,
) -> Option<()> {
    for (row, _) in &elimination.spare {
        if let Some(constraint) = constraints.get(*row) {
            errors.push(
                constraint.place.span(),
                format!(
                    "no unknown reaction keeps `{}`: mark one with `_` in `reactions`, with a part \
                     against it",
                    constraint.name
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
        } else if let Some(push) = pushes.first() {
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
