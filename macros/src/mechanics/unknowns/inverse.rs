//! Inverse dynamics: the drives that produce a given motion.
//!
//! The balances are those of [`super::reactions`], but the accelerations are given, and the drives
//! are unknown together with the reactions. The motion is assumed to be one that the drives can
//! produce: balances that contain no unknown are ignored. If coefficients depend on the
//! configuration, or if there are fewer drives than balances that contain them, [`super::drives`]
//! solves for them.

use crate::errors::Errors;
use crate::families::LoadKind;
use crate::mechanics::following::as_given;
use crate::model::{Model, Pair, Reaction, Variable, Vector, Workspace};
use crate::symbolic::Components;

use super::drives::solve_drives;
use super::inertial::acceleration_symbols;
use super::left_over::balances_left;
use super::reactions::solve_unknowns;
use super::rows::{BalanceRow, Unmoved};
use super::solvability::check_supports;
use super::unit::named_result;

/// Solves for the drives, each in the axes in which it is written.
pub fn derive_inverse(
    model: &Model,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<Vec<Components>> {
    let given = as_given(model, work);
    let model = given.as_ref().unwrap_or(model);
    let free = free_balances(model, work);
    let motion = accelerations(model, work);
    let solved = if model.constraints.is_empty() && model.state.axis.is_none() {
        solve(model, work, &free, motion, errors)?
    } else {
        solve_drives(model, work, &free, motion, errors)?
    };
    let drives = model.drives.iter().zip(solved);
    let drives = drives.map(|(drive, whole)| named_result(work, drive, whole, drive.frame));
    Some(drives.collect())
}

/// The drives. They are solved for with constant coefficients if these are constant in some axes
/// and there are as many drives as balances.
fn solve(
    model: &Model,
    work: &mut Workspace,
    free: &[BalanceRow],
    motion: Pair,
    errors: &mut Errors,
) -> Option<Vec<Vector>> {
    let mut rows = free.to_vec();
    if !model.reactions.is_empty() {
        rows.extend(balances_left(model, work));
    }
    let unknown: Vec<&Reaction> = model.reactions.iter().chain(&model.drives).collect();
    let solved = solve_unknowns(model, work, &unknown, rows, motion, Unmoved::Ignored);
    match solved {
        Ok(solved) if solved.is_constant && !solved.elimination.undetermined.is_empty() => {
            check_supports(model, work, &solved, errors)?;
            None
        }
        Ok(solved) if solved.is_constant && solved.is_balanced(work) => {
            let drives = model.drives.iter();
            Some(drives.map(|drive| solved.load(work, drive)).collect())
        }
        _ => solve_drives(model, work, free, motion, errors),
    }
}

/// The balances along the free directions of the body.
fn free_balances(model: &Model, work: &mut Workspace) -> Vec<BalanceRow> {
    let units = work.graph.unit_vectors();
    let along =
        |kind: LoadKind, direction: Components| BalanceRow::new("the balances", kind, direction);
    let mut rows = Vec::new();
    let linear = model.motion.linear_axes();
    rows.extend(linear.map(|axis| along(LoadKind::Force, units[axis])));
    if let Some(d) = model.hinge(&mut work.graph) {
        rows.push(along(LoadKind::Moment, d));
    } else {
        let angular = model.motion.angular_axes();
        rows.extend(angular.map(|axis| along(LoadKind::Moment, units[axis])));
    }
    rows
}

/// The accelerations as symbols; for a rod, the angular one is `u x u''`.
fn accelerations(model: &Model, work: &Workspace) -> Pair {
    let zeros = work.graph.zeros();
    let (mut linear, mut angular) = (zeros, zeros);
    for (id, variable, axis) in acceleration_symbols(model, work) {
        match variable {
            Variable::LinearAcceleration => linear[axis] = id,
            _ => angular[axis] = id,
        }
    }
    if model.state.axis.is_some() {
        angular = model.state.angular_acceleration;
    }
    Pair { linear, angular }
}
