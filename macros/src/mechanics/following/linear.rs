//! Loads that depend on unknowns that are solved for. They must be linear in unknown reactions and
//! accelerations together; anything else is an error.

use crate::errors::{Errors, Extent};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Load, Meaning, Point, Workspace};
use crate::symbolic::Id;

/// Words for messages: for an unknown, and for the correct form of a load that depends on it.
#[derive(Clone, Copy)]
pub struct Followed {
    any: &'static str,
    this: &'static str,
    form: &'static str,
}

/// The words for a body under constraints.
pub const REACTION: Followed = Followed {
    any: "an unknown reaction",
    this: "this unknown reaction",
    form: "a multiple of its components, such as `-mu * N.in_world().y`",
};

/// The words for a system.
pub const LOAD: Followed = Followed {
    any: "the load of a constraint",
    this: "the load of this constraint",
    form: "a multiple of it, such as `-mu * floor`",
};

const ACCELERATION: Followed = Followed {
    any: "an acceleration",
    this: "the acceleration",
    form: "a sum of its components, each with a factor that does not depend on it, such as \
           `-added * acceleration`",
};

impl Followed {
    /// The words for the kind of unknowns that these expressions depend on.
    fn in_parts(self, work: &Workspace, roots: &[Id]) -> Self {
        if work.accelerations_in(roots).is_empty() {
            self
        } else {
            ACCELERATION
        }
    }
}

/// Checks that each load equals its value without the unknowns plus its slopes times the unknowns,
/// which is proved in all states, and that its point of action does not depend on the unknowns.
pub fn check_linear<'l>(
    loads: impl Iterator<Item = &'l Load>,
    followed: Followed,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<()> {
    let before = errors.count();
    for load in loads {
        let place = load.mention.unwrap_or(load.extent);
        let name = load.name.to_string();
        let point = match load.point {
            Point::Fixed(_, offset) => offset.to_vec(),
            Point::Moving(offset) => work.entries(&[offset]),
        };
        if !unknowns_in(work, &point).is_empty() {
            let Followed { any, .. } = followed.in_parts(work, &point);
            let message = format!("the point of action of `{name}` cannot depend on {any}");
            errors.push(place, message);
            continue;
        }
        let roots = work.entries(&[load.force, load.moment]);
        check_parts(work, (&name, place), &roots, (followed, errors));
    }
    (errors.count() == before).then_some(())
}

/// The same for the components of one load.
pub fn check_parts(
    work: &mut Workspace,
    (name, place): (&str, Extent),
    roots: &[Id],
    (followed, errors): (Followed, &mut Errors),
) {
    if is_linear(work, roots) {
        return;
    }
    let Followed { this, form, .. } = followed.in_parts(work, roots);
    let message = format!("`{name}` is not linear in {this}: write {form}");
    errors.push(place, message);
}

/// The symbols of unknown reactions and of accelerations that expressions contain.
pub fn unknowns_in(work: &Workspace, roots: &[Id]) -> Vec<Id> {
    let is_unknown = |id: &Id| match work.meaning(*id) {
        Some(Meaning::Reaction(..)) => true,
        Some(Meaning::Of(_, variable, _)) => variable.is_acceleration(),
        _ => false,
    };
    let mut symbols = work.graph.nodes_of(roots);
    symbols.retain(is_unknown);
    symbols
}

/// Whether expressions are linear in the unknowns that they contain.
fn is_linear(work: &mut Workspace, roots: &[Id]) -> bool {
    let symbols = unknowns_in(work, roots);
    if symbols.is_empty() || work.graph.is_linear(roots, &symbols) {
        return true;
    }
    let zero = work.graph.zero();
    let graph = &mut work.graph;
    let is_known = |id: Id| symbols.contains(&id).then_some(zero);
    let without = graph.substitute(roots, is_known);
    let mut rest: Vec<Id> = roots
        .iter()
        .zip(without)
        .map(|(root, without)| graph.subtract(*root, without))
        .collect();
    for symbol in &symbols {
        let slopes = work.graph.derivative(roots, *symbol);
        if !unknowns_in(work, &slopes).is_empty() {
            return false;
        }
        let graph = &mut work.graph;
        for (rest, slope) in rest.iter_mut().zip(slopes) {
            let part = graph.multiply(slope, *symbol);
            *rest = graph.subtract(*rest, part);
        }
    }
    all_vanish(work, &rest)
}
