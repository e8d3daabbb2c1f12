//! Whether constraints and unknowns determine each other: what to say if they do not, and where.

use crate::errors::Errors;
use crate::model::Model;
use crate::symbolic::{Elimination, Id, Number};

use super::constraints::Constrained;
use super::pushes::Push;
use super::samples::sample;

/// The gradient of a constraint at one state, reduced by those before it.
struct Reduced {
    index: usize,
    lead: usize,
    gradient: Vec<Number>,
    /// The constraints that it is made of.
    of: Vec<usize>,
}

/// Constraints that follow from others are reported: the reactions would not be determined.
pub fn check_independent(
    model: &mut Model,
    constraints: &[Constrained],
    errors: &mut Errors,
) -> Option<()> {
    let roots: Vec<Id> = constraints
        .iter()
        .flat_map(|constraint| [constraint.rates.linear, constraint.rates.angular].concat())
        .collect();
    let values = sample(model, &roots);
    let mut basis: Vec<Reduced> = Vec::new();
    let mut independent = true;
    for (index, gradient) in values.chunks(6).enumerate() {
        let (gradient, of) = reduce(gradient.to_vec(), &basis);
        if let Some(lead) = gradient.iter().position(|entry| !entry.is_zero()) {
            let mut of = of;
            of.push(index);
            basis.push(Reduced {
                index,
                lead,
                gradient,
                of,
            });
            continue;
        }
        let (name, place) = (&constraints[index].name, &constraints[index].place);
        let others = of
            .into_iter()
            .map(|other| format!("`{}`", constraints[other].name));
        let others: Vec<String> = others.collect();
        let message = if others.is_empty() {
            format!("no acceleration changes `{name}`: no load can keep it at zero")
        } else {
            let others = others.join(" and ");
            format!("`{name}` is kept already by {others}: leave one of them out")
        };
        errors.push(place.span(), message);
        independent = false;
    }
    independent.then_some(())
}

/// A gradient without its parts along `basis`, and the constraints that these are made of.
fn reduce(mut gradient: Vec<Number>, basis: &[Reduced]) -> (Vec<Number>, Vec<usize>) {
    let mut of = Vec::new();
    for known in basis {
        let factor = gradient[known.lead].checked_div(&known.gradient[known.lead]);
        let factor = factor.unwrap_or_else(Number::zero);
        if factor.is_zero() {
            continue;
        }
        for (entry, part) in gradient.iter_mut().zip(&known.gradient) {
            *entry = entry.clone() - factor.clone() * part.clone();
        }
        of.extend(known.of.iter().copied());
        of.push(known.index);
    }
    of.sort_unstable();
    of.dedup();
    (gradient, of)
}

/// Unknowns that no constraint determines, and constraints that no unknown keeps.
pub fn check_elimination(
    model: &Model,
    constraints: &[Constrained],
    pushes: &[Push],
    elimination: &Elimination,
    errors: &mut Errors,
) -> Option<()> {
    for column in &elimination.undetermined {
        let push = &pushes[*column];
        let name = push.name(model);
        errors.push(
            push.place,
            format!(
                "nothing determines `{name}`: no constraint is left for it to keep; write its \
                 value, 0 if nothing holds the body there"
            ),
        );
    }
    for row in &elimination.spare {
        if let Some(constraint) = constraints.get(*row) {
            errors.push(
                constraint.place.span(),
                format!(
                    "no unknown reaction keeps `{}`: mark one with `_` in `reactions`, with a part \
                     against it",
                    constraint.name
                ),
            );
        } else if let Some(push) = pushes.first() {
            errors.push(
                push.place,
                format!(
                    "under `motion: {}` nothing balances the moment of the reactions: let them act \
                     at G, or leave a moment in `reactions` unknown",
                    model.motion.word()
                ),
            );
        }
    }
    (elimination.undetermined.is_empty() && elimination.spare.is_empty()).then_some(())
}
