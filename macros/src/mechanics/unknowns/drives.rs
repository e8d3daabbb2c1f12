//! Drives that enter the balances with coefficients that depend on the configuration.
//!
//! ```text
//! sum of u_j w_j + b = 0      w_j: force and moment of one unit of the unknown j;
//!                             b: the remainder without them
//! ```
//!
//! If, in some axes, there are as many balances as unknowns in them, the balances are solved
//! directly. If there are more, the motion is assumed to be one that the drives can produce. Then
//! the drives follow from Gauss's principle: the remaining acceleration is minimal in the metric of
//! the kinetic energy:
//!
//! ```text
//! sum of (w_i . M^-1 w_j) u_j = -w_i . M^-1 b
//! ```

use crate::errors::Errors;
use crate::mechanics::balances::{free_moment, response};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Model, Pair, Vector, Workspace};
use crate::symbolic::{Equation, Id, Size};

use super::inertial::{balances_of, balances_without_unknowns};
use super::left_over::balances_left;
use super::pushes::{known_loads, pushes};
use super::rows::{BalanceRow, equations};
use super::solvability::{OF_DRIVES, check_across, check_determined};
use super::unit::{Unit, assemble, name_values, names};

/// Solves for the drives of the model; under constraints, together with the reactions that keep the
/// constraints. `free` are the balances along the free directions of the body.
pub fn solve_drives(
    model: &Model,
    work: &mut Workspace,
    free: &[BalanceRow],
    accelerations: Pair,
    errors: &mut Errors,
) -> Option<Vec<Vector>> {
    let pushes = if model.constraints.is_empty() {
        Vec::new()
    } else {
        pushes(model, work)
    };
    // if no load depends on it, the load of a support only follows from the motion, and is left out
    let meets_supports = pushes.iter().any(|push| push.supports && push.is_followed);
    let is_held = !model.constraints.is_empty() && !model.motion.has_attitude();
    let held = if is_held || meets_supports {
        balances_left(model, work)
    } else {
        Vec::new()
    };
    let pushes = pushes.into_iter();
    let pushes = pushes.filter(|push| !push.supports || meets_supports);
    let mut units: Vec<Unit<'_>> = pushes.map(|push| push.unit).collect();
    units.extend(Unit::list(model, work, &model.drives, None));
    if let Some(axis) = model.state.axis {
        check_across(model, work, axis, units.iter(), errors)?;
    }
    let rest = if model.constraints.is_empty() {
        balances_without_unknowns(model, work, accelerations)
    } else {
        let loads = known_loads(model, work);
        balances_of(model, work, &loads, Vec::new(), accelerations)
    };
    let rows = [free, &held].concat();
    let system = as_many(model, work, &rows, &units, rest)
        .unwrap_or_else(|| nearest(model, work, &held, &units, rest));
    let elimination = work.graph.solve(system, units.len());
    let names = names(model, &units);
    check_determined(work, &names, &elimination, |_| OF_DRIVES, errors)?;
    name_values(work, &names, &elimination);
    let values = || units.iter().zip(elimination.values.iter().copied());
    let drives = model.drives.iter();
    let drives = drives.map(|drive| assemble(work, drive, values()));
    Some(drives.collect())
}

/// The balances that contain unknowns, in axes in which there are at most as many of them as
/// unknowns. Axes in which the coefficients are known early are preferred.
fn as_many(
    model: &Model,
    work: &mut Workspace,
    rows: &[BalanceRow],
    units: &[Unit<'_>],
    rest: (Vector, Vector),
) -> Option<Vec<Equation>> {
    let (world, body) = (Frame::WORLD, model.state.body);
    // for a hinge, moments are about an axis that is fixed in the body
    let is_hinged = model.motion.is_hinged();
    let mut found = None;
    for frames in [(world, body), (body, body), (world, world), (body, world)] {
        if is_hinged && frames.1 == world {
            continue;
        }
        let equations = balances(work, rows, units, rest, frames);
        let mut coefficients = equations.iter().flat_map(|one| &one.coefficients);
        let is_early = coefficients.all(|id| work.graph.is_early(*id));
        if equations.len() <= units.len() && (is_early || found.is_none()) {
            found = Some(equations);
            if is_early {
                break;
            }
        }
    }
    found
}

/// The balances of forces and of moments, in these axes, that contain unknowns.
fn balances(
    work: &mut Workspace,
    rows: &[BalanceRow],
    units: &[Unit<'_>],
    rest: (Vector, Vector),
    frames: (Frame, Frame),
) -> Vec<Equation> {
    let mut system = Vec::new();
    for row in rows {
        let loads = units.iter().map(|unit| (unit.force, unit.moment));
        let sides = row.sides(work, loads, rest, frames);
        if !all_vanish(work, &sides.0) {
            system.push(sides);
        }
    }
    equations(work, system)
}

/// The equations of Gauss's principle, and the balances that hold the body.
fn nearest(
    model: &Model,
    work: &mut Workspace,
    held: &[BalanceRow],
    units: &[Unit<'_>],
    rest: (Vector, Vector),
) -> Vec<Equation> {
    let is_in_body = |unit: &Unit<'_>| work.is_in(unit.force, model.state.body);
    // since a mass is the same in all axes, any axes will do for forces
    let of_forces = if model.motion.has_attitude() && units.iter().all(is_in_body) {
        model.state.body
    } else {
        Frame::WORLD
    };
    let in_axes = |work: &mut Workspace, force: Vector, moment: Vector| {
        let force = work.components(force, of_forces);
        let moment = work.components(moment, model.state.axes);
        Pair {
            linear: force,
            angular: free_moment(model, work, moment),
        }
    };
    let loads: Vec<Pair> = units
        .iter()
        .map(|unit| in_axes(work, unit.force, unit.moment))
        .collect();
    let frames = (Frame::WORLD, Frame::WORLD);
    let mut system = balances(work, held, units, rest, frames);
    let rest = in_axes(work, rest.0, rest.1);
    let mut powers = Vec::new();
    for load in &loads {
        let by_load = response(model, work, *load);
        let graph = &mut work.graph;
        let power = loads.iter().map(|load| by_load.dot(graph, *load));
        let coefficients: Vec<Id> = power.collect();
        let rest = by_load.dot(graph, rest);
        powers.push((coefficients, graph.negate(rest)));
    }
    let mut powers = equations(work, powers);
    for (row, equation) in powers.iter_mut().enumerate() {
        equation.sizes[row] = Size::Squares;
    }
    system.extend(powers);
    system
}
