//! Unknown reactions, from the balances that do not determine the accelerations.
//!
//! The accelerations follow from the balances along the free directions. Ideal reactions do not
//! appear there: the motion needs no reaction, and none is computed unless it is requested. The
//! remaining part of (1.3) and (1.4) is linear in the reactions:
//!
//! ```text
//! sum of F + sum of R - m a = 0
//! sum of M_C + sum of (P - C) x R - J_C w' - w x J_C w = 0
//! ```

use crate::errors::{Errors, Extent};
use crate::families::LoadKind;
use crate::mechanics::balances::arm;
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Model, Pair, Reaction, Workspace};
use crate::symbolic::Components;

use super::inertial::balances_without_unknowns;
use super::left_over::balances_left;
use super::rows::{BalanceRow, SolvedBalances, Unmoved, equations};
use super::solvability::{check_balanced, check_supports, check_workless};
use super::unit::{Unit, named_result};

/// Solves for the unknown components. Failures are reported at these components.
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
            return errors.report(place, "in world axes the part of this reaction that is known turns against the body: write it in body axes, or leave all its components unknown");
        }
    };
    let determined = check_supports(model, work, &solved, errors);
    check_balanced(work, &solved, errors)?;
    determined?;
    let in_world = unknown.into_iter().map(|reaction| {
        let whole = solved.load(work, reaction);
        named_result(work, reaction, whole, Frame::WORLD)
    });
    Some(in_world.collect())
}

/// Solves for the components of unknown loads that satisfy the balances of `rows`, in a motion with
/// these accelerations. If the coefficients are not constant in any axes, the error is the place of
/// an unknown that causes this.
pub fn solve_unknowns<'m>(
    model: &Model,
    work: &mut Workspace,
    loads: &[&'m Reaction],
    mut rows: Vec<BalanceRow>,
    accelerations: Pair,
    unmoved: Unmoved,
) -> Result<SolvedBalances<'m>, Extent> {
    let frame = choose_frame(model, work, loads)?;
    let units = Unit::list(model, work, loads.iter().copied(), Some(frame));
    let rest = balances_without_unknowns(model, work, accelerations);
    let mut system = Vec::new();
    rows.retain(|row| {
        let loads = units.iter().map(|unit| (unit.force, unit.moment));
        let sides = row.sides(work, loads, rest, (frame, frame));
        let is_ignored = unmoved == Unmoved::Ignored && all_vanish(work, &sides.0);
        if !is_ignored {
            system.push(sides);
        }
        !is_ignored
    });
    let mut coefficients = system.iter().flat_map(|(row, _)| row);
    let is_constant = coefficients.all(|id| work.graph.is_early(*id));
    let system = equations(work, system);
    let elimination = work.graph.solve(system, units.len());
    Ok(SolvedBalances {
        units,
        rows,
        elimination,
        is_constant,
    })
}

/// The axes of the balances: those of the world if all unknowns can be written in them with
/// constant coefficients, otherwise those of the body. An unknown vector with all three components
/// can be written in any axes.
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
        let arm = arm(&model.state, work, point, center);
        let has_arm = kind == LoadKind::Force && !arm.is_zero();
        in_world &= !has_arm && (is_free || written == Frame::WORLD);
        if !is_free && written == Frame::WORLD {
            mixed = mixed.or(place);
        }
    }
    // without an attitude, both axes are the same
    if in_world || !model.motion.has_attitude() {
        return Ok(Frame::WORLD);
    }
    mixed.map_or(Ok(model.state.body), Err)
}

/// Whether the unknown components of a reaction are the same unknowns in body axes and in world
/// axes: all three; or, if the body rotates about a coordinate axis, the one along it or the two
/// perpendicular to it.
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
