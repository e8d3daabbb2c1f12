//! Whether the balances determine the reactions: what to say if they do not, and where.

use crate::errors::Errors;
use crate::model::{AXES, LoadKind, Model};
use crate::symbolic::{Graph, Id, Number, Solution};

use super::newton_euler::arm;
use super::reactions::{Row, Unknown};

/// Along the directions in which the body moves freely, a reaction would be a drive.
pub fn check_workless(model: &mut Model, errors: &mut Errors) -> Option<()> {
    let center = model.state.center(&mut model.frames);
    let hinge = model.hinge();
    let mut workless = true;
    for index in 0..model.reactions.len() {
        let (kind, point, place) = {
            let reaction = &model.reactions[index];
            (
                reaction.kind,
                reaction.point,
                reaction.unknown.first().map(|(_, place)| *place),
            )
        };
        let Some(place) = place else { continue };
        let arm = arm(model, point, center);
        let works = match kind {
            LoadKind::Force if model.motion.translates() => true,
            LoadKind::Force => !model.frames.is_zero_vector(arm) && hinge.is_none(),
            LoadKind::Moment => model.motion.has_attitude() && hinge.is_none(),
        };
        if works {
            let motion = model.motion.word();
            errors.push(place, format!("this would move the body, and a reaction does no work: under `motion: {motion}` nothing holds the body in this direction"));
            workless = false;
        }
    }
    workless.then_some(())
}

/// Unknowns that are not determined, and balances that nothing can meet.
pub fn check_solution(
    model: &mut Model,
    unknowns: &[Unknown],
    rows: &[Row],
    solution: &Solution,
    errors: &mut Errors,
) -> Option<()> {
    let component = |model: &Model, index: usize| {
        let unknown = &unknowns[index];
        let reaction = &model.reactions[unknown.reaction];
        let is_scalar = reaction.kind == LoadKind::Moment && model.motion.is_planar();
        if is_scalar {
            reaction.name.to_string()
        } else {
            format!("{}.{}", reaction.name, AXES[unknown.axis])
        }
    };
    for together in &solution.undetermined {
        // the last of them is the one to give up
        let Some((last, _)) = together.last() else {
            continue;
        };
        let message = if together.len() == 1 {
            format!(
                "nothing determines `{}`: write its value, 0 if the support does not hold it",
                component(model, *last)
            )
        } else {
            let mut combination = String::new();
            for (position, (index, factor)) in together.iter().enumerate() {
                combination += &term(
                    &model.frames.graph,
                    *factor,
                    &component(model, *index),
                    position == 0,
                );
            }
            format!(
                "the body is held more than once: only `{combination}` is determined; write the value of one of them, 0 if that support does not hold it"
            )
        };
        errors.push(unknowns[*last].place, message);
    }
    for row in &solution.unbalanced {
        let place = unknowns.first().map(|unknown| unknown.place)?;
        errors.push(
            place,
            format!(
                "nothing balances {}: leave another component of a reaction unknown",
                rows[*row].name
            ),
        );
    }
    (solution.undetermined.is_empty() && solution.unbalanced.is_empty()).then_some(())
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
