//! Whether the balances determine the reactions: what to say if they do not, and where.

use crate::errors::Errors;
use crate::families::LoadKind;
use crate::mechanics::balances::arm;
use crate::model::{Frame, Model, Motion, Reaction, Workspace};
use crate::symbolic::{Graph, Id, Number};

use super::unknown::Solved;

/// Along the directions in which the body moves freely, a reaction would be a drive: the
/// accelerations were found without it.
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

/// Whether a unit load along this axis has a power for some velocity that the support allows.
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
    let arm = arm(model, work, point, center);
    let arm = work.components(arm, Frame::Body);
    let graph = &mut work.graph;
    // d.(P - C) x e = e.d x (P - C); without an axis, any d
    let swept = hinge.map_or(arm, |d| graph.cross(d, arm));
    let stays = swept.map(|component| graph.vanishes(component));
    let turns_with_body = frame == Frame::Body || is_whole;
    match hinge {
        Some(_) if turns_with_body => !stays[axis],
        // what is written in world axes turns through all directions across the axis
        Some(d) => stays != [true; 3] && !graph.is_along(d, axis),
        None => stays != [true; 3],
    }
}

fn drive(model: &Model, reaction: &Reaction) -> String {
    let motion = model.motion.word();
    if !model.motion.is_supported() {
        return format!(
            "this would move the body, and a reaction does no work: under `motion: {motion}` nothing \
             holds the body in this direction"
        );
    }
    let held = if model.motion == Motion::FixedAxis {
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

/// Unknowns that are not determined, and balances that nothing can meet.
pub fn check_solution(
    model: &Model,
    work: &Workspace,
    solved: &Solved<'_>,
    errors: &mut Errors,
) -> Option<()> {
    let determined = check_determined(model, work, solved, errors);
    for row in &solved.solution.unbalanced {
        let place = solved.unknowns.first().map(|unknown| unknown.place)?;
        errors.push(
            place,
            format!(
                "nothing balances {}: leave another component of a reaction unknown",
                solved.rows[*row].name
            ),
        );
    }
    determined.filter(|()| solved.solution.unbalanced.is_empty())
}

/// Unknowns that are not determined.
pub fn check_determined(
    model: &Model,
    work: &Workspace,
    solved: &Solved<'_>,
    errors: &mut Errors,
) -> Option<()> {
    let (unknowns, solution) = (&solved.unknowns, &solved.solution);
    let component = |index: usize| {
        let unknown = &unknowns[index];
        unknown.load.component_name(model.motion, unknown.axis)
    };
    for together in &solution.undetermined {
        // the last of them is the one to give up
        let Some((last, _)) = together.last() else {
            continue;
        };
        let message = if together.len() == 1 {
            format!(
                "nothing determines `{}`: write its value, 0 if the support does not hold it",
                component(*last)
            )
        } else {
            let mut combination = String::new();
            for (position, (index, factor)) in together.iter().enumerate() {
                combination += &term(&work.graph, *factor, &component(*index), position == 0);
            }
            format!(
                "more is unknown than the balances determine: only `{combination}` is determined; write the value of one of them, 0 if it carries nothing"
            )
        };
        errors.push(unknowns[*last].place, message);
    }
    solution.undetermined.is_empty().then_some(())
}

/// `+ 2 * a.x` of a combination.
fn term(graph: &Graph, factor: Id, name: &str, is_first: bool) -> String {
    let number = graph.as_number(factor).cloned().unwrap_or_else(Number::one);
    let sign = match (number.is_negative(), is_first) {
        (true, true) => "-",
        (true, false) => " - ",
        (false, true) => "",
        (false, false) => " + ",
    };
    let magnitude = number.abs();
    if magnitude.is_one() {
        format!("{sign}{name}")
    } else {
        format!("{sign}{} * {name}", magnitude.to_f64())
    }
}
