//! Unknown reactions, from the balances that the accelerations leave over.
//!
//! The accelerations follow from the balances along the free directions, in which ideal reactions
//! have no part: no reaction is needed to move the body, and none is computed unless asked for.
//! What is left of (1.3) and (1.4) is linear in the reactions:
//!
//! ```text
//! sum of F + sum of R - m a = 0
//! sum of M_C + sum of (P - C) x R - J_C w' - w x J_C w = 0
//! ```

use crate::errors::{Errors, Extent};
use crate::families::LoadKind;
use crate::mechanics::balances::arm;
use crate::model::{Frame, Model, Pair, Reaction, Vector, Workspace};
use crate::symbolic::{Components, Id};

use super::inertial::balances_without_unknowns;
use super::left_over::balances_left;
use super::solvability::{check_balanced, check_supports, check_workless};
use super::unknown::{Row, Solved, Unknown, Unmoved, equations};

/// Solves for the unknown components; what they cannot be solved for is reported on them.
pub fn derive_reactions(
    model: &Model,
    work: &mut Workspace,
    accelerations: Pair,
    errors: &mut Errors,
) -> Option<Vec<Components>> {
    if model.reactions.is_empty() {
        return Some(Vec::new());
    }
    check_workless(model, work, errors)?;
    let rows = balances_left(model, work);
    let unknown: Vec<&Reaction> = model.reactions.iter().collect();
    let solved = match solve_unknowns(model, work, &unknown, rows, accelerations, Unmoved::Checked)
    {
        Ok(solved) => solved,
        Err(place) => {
            errors.push(place, "in world axes the part of this reaction that is known turns against the body: write it in body axes, or leave all its components unknown");
            return None;
        }
    };
    let determined = check_supports(model, work, &solved, errors);
    check_balanced(work, &solved, errors)?;
    determined?;
    let in_world = unknown.into_iter().map(|reaction| {
        let whole = assemble(work, &solved, reaction);
        let vector = work.components(whole, Frame::WORLD);
        let vector = work.graph.results(vector);
        work.labels.vector(&reaction.name.to_string(), vector);
        vector
    });
    Some(in_world.collect())
}

/// The components of unknown loads that meet the balances of `rows`, in a motion with these
/// accelerations. Where coefficients are not constant in any axes, the place of an unknown that
/// makes them so.
pub fn solve_unknowns<'m>(
    model: &Model,
    work: &mut Workspace,
    loads: &[&'m Reaction],
    mut rows: Vec<Row>,
    accelerations: Pair,
    unmoved: Unmoved,
) -> Result<Solved<'m>, Extent> {
    let frame = choose_frame(model, work, loads)?;
    let unknowns = list_unknowns(loads);
    if unmoved == Unmoved::Ignored {
        rows.retain(|row| {
            let mut coefficients = unknowns.iter();
            coefficients.any(|unknown| {
                let coefficient = coefficient(model, work, frame, row, unknown);
                !work.graph.vanishes(coefficient)
            })
        });
    }
    let (force, moment) = balances_without_unknowns(model, work, accelerations);
    let (force, moment) = (
        work.components(force, frame),
        work.components(moment, frame),
    );
    let mut system = Vec::new();
    for row in &rows {
        let coefficients: Vec<Id> = unknowns
            .iter()
            .map(|unknown| coefficient(model, work, frame, row, unknown))
            .collect();
        let graph = &mut work.graph;
        let known = graph.dot(row.direction, row.of(force, moment));
        let right = graph.negate(known);
        system.push((coefficients, right));
    }
    let mut coefficients = system.iter().flat_map(|(row, _)| row);
    let is_constant = coefficients.all(|id| work.graph.is_early(*id));
    let system = equations(work, system);
    let elimination = work.graph.solve(system, unknowns.len());
    Ok(Solved {
        frame,
        unknowns,
        rows,
        elimination,
        is_constant,
    })
}

/// The axes in which the balances are written: those of the world where all unknowns can be written
/// in them with constant coefficients, else those of the body. All three components of an unknown
/// vector can be written in any axes.
fn choose_frame(model: &Model, work: &mut Workspace, loads: &[&Reaction]) -> Result<Frame, Extent> {
    let center = model.state.center(work);
    let mut in_world = true;
    let mut mixed = None;
    for reaction in loads {
        let is_free = is_in_any_axes(model, work, reaction);
        let (point, kind, written) = (reaction.point, reaction.kind, reaction.frame);
        let place = reaction.unknown.first().map(|(_, place)| *place);
        if let (Some(_), Some(place)) = (reaction.along, place) {
            return Err(place);
        }
        let arm = arm(model, work, point, center);
        let has_arm = kind == LoadKind::Force && !arm.is_zero();
        in_world &= !has_arm && (is_free || written == Frame::WORLD);
        if !is_free && written == Frame::WORLD {
            mixed = mixed.or(place);
        }
    }
    // without an attitude the axes are the same
    if in_world || !model.motion.has_attitude() {
        return Ok(Frame::WORLD);
    }
    mixed.map_or(Ok(model.state.body), Err)
}

/// Whether the unknown components of a reaction are the same unknowns in the axes of the body and
/// in those of the world: all of them, and, about an axis of coordinates, that along it or those
/// across it.
fn is_in_any_axes(model: &Model, work: &mut Workspace, reaction: &Reaction) -> bool {
    let hinge = model.hinge(&mut work.graph);
    if reaction.is_whole(model.motion) {
        return true;
    }
    let axes: Vec<usize> = reaction.unknown.iter().map(|(axis, _)| *axis).collect();
    let graph = &work.graph;
    let along = hinge.and_then(|d| (0..3).find(|axis| graph.is_along(d, *axis)));
    along.is_some_and(|along| axes == [along] || (axes.len() == 2 && !axes.contains(&along)))
}

fn list_unknowns<'m>(loads: &[&'m Reaction]) -> Vec<Unknown<'m>> {
    let each = loads.iter().copied();
    let all = each.flat_map(|load| {
        let unknown = load.unknown.iter();
        unknown.map(move |(axis, place)| Unknown {
            load,
            axis: *axis,
            place: *place,
        })
    });
    all.collect()
}

/// How an unknown enters a row: a force along its axis, and by its arm as a moment.
fn coefficient(
    model: &Model,
    work: &mut Workspace,
    frame: Frame,
    row: &Row,
    unknown: &Unknown<'_>,
) -> Id {
    let Reaction { kind, point, .. } = *unknown.load;
    let center = model.state.center(work);
    let graph = &mut work.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = [0, 1, 2].map(|axis| if axis == unknown.axis { one } else { zero });
    let part = match (row.kind, kind) {
        (LoadKind::Force, LoadKind::Moment) => return zero,
        (LoadKind::Force, LoadKind::Force) | (LoadKind::Moment, LoadKind::Moment) => unit,
        (LoadKind::Moment, LoadKind::Force) => {
            let arm = arm(model, work, point, center);
            let arm = work.components(arm, frame);
            work.graph.cross(arm, unit)
        }
    };
    work.graph.dot(row.direction, part)
}

/// Given and solved components of an unknown load together.
pub fn assemble(work: &mut Workspace, solved: &Solved<'_>, load: &Reaction) -> Vector {
    let mut components = work.graph.zeros();
    for (unknown, value) in solved.unknowns.iter().zip(&solved.elimination.values) {
        if unknown.load.name == load.name {
            components[unknown.axis] = work.graph.unnamed(*value);
        }
    }
    let given = work.vector(load.frame, load.given);
    let solved = work.vector(solved.frame, components);
    work.add(given, solved)
}
