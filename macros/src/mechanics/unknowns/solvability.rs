//! Checks that the balances determine the reactions, with errors at their places.

use crate::errors::{Errors, Extent};
use crate::families::LoadKind;
use crate::mechanics::balances::{arm, not_vanishing, parts_along};
use crate::model::{Axis, Model, Reaction, Workspace};
use crate::symbolic::{Elimination, Number, Undetermined};

use super::rows::SolvedBalances;
use super::unit::{Unit, names};

/// Reports reactions along the free directions of the body. There, a reaction would be a drive, but
/// the accelerations were found without it.
pub fn check_workless(model: &Model, work: &mut Workspace, errors: &mut Errors) -> Option<()> {
    let mut workless = true;
    for reaction in &model.reactions {
        let unknown = &reaction.unknown;
        if let (Some(_), Some((_, place))) = (reaction.along, unknown.first()) {
            errors.push(*place, "a reaction along a direction of its own keeps a constraint, and there are none: write its components, as in `body(_, 0)`");
            workless = false;
            continue;
        }
        let working = unknown
            .iter()
            .find(|(axis, _)| does_work(model, work, reaction, *axis));
        if let Some((_, place)) = working {
            errors.push(*place, drive(model, reaction));
            workless = false;
        }
    }
    workless.then_some(())
}

/// Whether a unit load along this axis does work in some motion that the support allows.
fn does_work(model: &Model, work: &mut Workspace, reaction: &Reaction, axis: usize) -> bool {
    let (kind, point, frame) = (reaction.kind, reaction.point, reaction.frame);
    let is_whole = reaction.is_whole(model.motion);
    let hinge = model.hinge(&mut work.graph);
    if kind == LoadKind::Moment {
        return match hinge {
            Some(d) => !work.graph.vanishes(d[axis]),
            None => model.motion.has_attitude(),
        };
    }
    if model.motion.translates() {
        return true;
    }
    let center = model.state.center(work);
    let arm = arm(&model.state, work, point, center);
    let arm = work.components(arm, model.state.body);
    let graph = &mut work.graph;
    // d.(P - C) x e = e.d x (P - C) must vanish; without an axis, for any d
    let swept = hinge.map_or(arm, |d| graph.cross(d, arm));
    let stays = swept.map(|component| graph.vanishes(component));
    let turns_with_body = frame == model.state.body || is_whole;
    match hinge {
        Some(_) if turns_with_body => !stays[axis],
        // as the body rotates, a load in world axes takes all directions perpendicular to the axis
        Some(d) => stays != [true; 3] && !graph.is_along(d, axis),
        None => stays != [true; 3],
    }
}

fn drive(model: &Model, reaction: &Reaction) -> String {
    let motion = model.motion.word;
    if !model.motion.is_supported() {
        return format!(
            "this would move the body, and a reaction does no work: under `motion: {motion}` nothing \
             holds the body in this direction"
        );
    }
    let held = if model.motion.has_written_axis() {
        "the axis"
    } else {
        "the point that is held"
    };
    let reason = if reaction.kind == LoadKind::Moment {
        format!("about {held} the body turns freely: write the value, 0 if there is none")
    } else {
        format!(
            "away from {held} this force would turn the body: let it act there, or write the value"
        )
    };
    format!("a reaction does no work, and {reason}")
}

/// What to say about undetermined unknowns of some kind.
#[derive(Clone, Copy)]
pub struct Advice<'a> {
    /// If the unknown appears in no equation.
    pub alone: &'static str,
    /// When the value of the unknown is zero.
    pub zero: &'a str,
}

/// For reactions under constraints.
pub const OF_REACTIONS: Advice<'static> = Advice {
    alone: "no constraint is left for it to keep; write its value, 0 if nothing holds the body there",
    zero: "if it carries nothing",
};

pub const OF_DRIVES: Advice<'static> = Advice {
    alone: "it does not act along a free direction",
    zero: "if it is at rest",
};

/// Reports undetermined unknowns of a support and of additional drives.
pub fn check_supports(
    model: &Model,
    work: &Workspace,
    solved: &SolvedBalances<'_>,
    errors: &mut Errors,
) -> Option<()> {
    let advice = |column: usize| {
        let mut drives = model.drives.iter();
        if drives.any(|drive| core::ptr::eq(drive, solved.units[column].load)) {
            OF_DRIVES
        } else {
            Advice {
                alone: "write its value, 0 if the support does not hold it",
                zero: "if it carries nothing",
            }
        }
    };
    let names = names(model, &solved.units);
    check_determined(work, &names, &solved.elimination, advice, errors)
}

/// Reports undetermined unknowns, each by its name at its place.
pub fn check_determined<'a>(
    work: &Workspace,
    unknowns: &[(String, Extent)],
    elimination: &Elimination,
    advice: impl Fn(usize) -> Advice<'a>,
    errors: &mut Errors,
) -> Option<()> {
    for Undetermined {
        column,
        others,
        sum,
    } in &elimination.undetermined
    {
        let (name, place) = &unknowns[*column];
        let Advice { alone, zero } = advice(*column);
        let others = others
            .iter()
            .map(|other| format!("`{}`", unknowns[*other].0));
        let others: Vec<String> = others.collect();
        let numbers: Option<Vec<(&Number, &str)>> = sum
            .iter()
            .map(|(column, factor)| Some((work.graph.as_number(*factor)?, &*unknowns[*column].0)))
            .collect();
        let message = match numbers {
            _ if others.is_empty() => format!("nothing determines `{name}`: {alone}"),
            Some(terms) => format!(
                "more is unknown than the balances determine: only `{}` is determined; write the \
                 value of one of them, 0 {zero}",
                combination(&terms)
            ),
            None => format!(
                "more is unknown than the balances determine: {} can replace `{name}`; write the value \
                 of one of them, 0 {zero}",
                others.join(" and ")
            ),
        };
        errors.push(*place, message);
    }
    elimination.undetermined.is_empty().then_some(())
}

/// A sum in words, such as `a.x + 2 * b.x`.
fn combination(terms: &[(&Number, &str)]) -> String {
    let terms = terms.iter().enumerate().map(|(index, (number, name))| {
        let sign = match (number.is_negative(), index) {
            (true, 0) => "-",
            (true, _) => " - ",
            (false, 0) => "",
            (false, _) => " + ",
        };
        let magnitude = number.abs();
        if magnitude.is_one() {
            format!("{sign}{name}")
        } else {
            format!("{sign}{} * {name}", magnitude.to_f64())
        }
    });
    terms.collect()
}

/// Reports balances that no unknown can satisfy, at the first unknown.
pub fn check_balanced(
    work: &Workspace,
    solved: &SolvedBalances<'_>,
    errors: &mut Errors,
) -> Option<()> {
    for row in solved.unbalanced(work) {
        let place = solved.units.first().map(|unit| unit.place)?;
        let name = row.name;
        errors.push(
            place,
            format!("nothing balances {name}: leave another component of a reaction unknown"),
        );
    }
    solved.is_balanced(work).then_some(())
}

/// Reports moments about the axis of a rod, which nothing balances: the moment of one unit of an
/// unknown must have no part along the axis.
pub fn check_across<'u>(
    model: &Model,
    work: &mut Workspace,
    axis: Axis,
    units: impl Iterator<Item = &'u Unit<'u>>,
    errors: &mut Errors,
) -> Option<()> {
    let units: Vec<&Unit<'_>> = units.collect();
    let parts = parts_along(work, axis, units.iter().map(|unit| unit.moment));
    let wrong = not_vanishing(work, &parts);
    for index in &wrong {
        let unit = units[*index];
        errors.push(
            unit.place,
            format!(
                "`{}` has a moment about the axis, about which a rod has no inertia: let it act on \
                 the axis, or write a direction across it, as in `_ * axis.cross(k)`",
                unit.name(model)
            ),
        );
    }
    wrong.is_empty().then_some(())
}
