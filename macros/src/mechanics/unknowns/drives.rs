//! Drives that enter the balances with coefficients that depend on the configuration.
//!
//! ```text
//! sum of u_j w_j + b = 0      w_j: force and moment of one unit of the unknown j;
//!                             b: what is left without them
//! ```
//!
//! As many balances as unknowns, along axes in which no other has a part in them, are solved as
//! they are. Where there are more, the motion is taken to be one that the drives can make, and they
//! follow from Gauss's principle, by which the acceleration they leave over is least in the metric
//! of the kinetic energy:
//!
//! ```text
//! sum of (w_i . M^-1 w_j) u_j = -w_i . M^-1 b
//! ```

use crate::errors::{Errors, Extent};
use crate::families::LoadKind;
use crate::mechanics::balances::{arm, free_moment, response};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Model, Pair, Reaction, Vector, Workspace};
use crate::symbolic::{Components, Equation, Id, Size};

use super::inertial::{balances_of, balances_without_unknowns};
use super::left_over::balances_left;
use super::pushes::{Push, given_loads, pushes};
use super::rod::check_across;
use super::solvability::{OF_DRIVES, check_determined};
use super::unknown::{Row, equations};

/// One unit of an unknown.
struct Column<'m> {
    load: &'m Reaction,
    axis: usize,
    place: Extent,
    /// In the axes in which it is written.
    direction: Vector,
    force: Vector,
    /// About the center.
    moment: Vector,
}

/// Solves for the drives of the model, under constraints together with the reactions that keep
/// these. `free` are the balances along the directions in which the body moves freely.
pub fn solve_drives(
    model: &Model,
    work: &mut Workspace,
    free: &[Row],
    accelerations: Pair,
    errors: &mut Errors,
) -> Option<Vec<Vector>> {
    let pushes = if model.constraints.is_empty() {
        Vec::new()
    } else {
        pushes(model, work, errors)?
    };
    // else what a support carries follows from the motion, and drives nothing
    let meets_supports = pushes.iter().any(|push| push.supports && push.is_followed);
    let is_held = !model.constraints.is_empty() && !model.motion.has_attitude();
    let held = if is_held || meets_supports {
        balances_left(model, work)
    } else {
        Vec::new()
    };
    let pushes = pushes
        .iter()
        .filter(|push| !push.supports || meets_supports);
    let columns = columns(model, work, pushes);
    if let Some(axis) = model.state.axis {
        let moments = columns.iter().map(|column| column.turning(model, work));
        check_across(work, axis, &moments.collect::<Vec<_>>(), errors)?;
    }
    let rest = if model.constraints.is_empty() {
        balances_without_unknowns(model, work, accelerations)
    } else {
        let loads = given_loads(model, work);
        balances_of(model, work, &loads, Vec::new(), accelerations)
    };
    let rows = [free, &held].concat();
    let system = as_many(model, work, &rows, &columns, rest)
        .unwrap_or_else(|| nearest(model, work, &held, &columns, rest));
    let elimination = work.graph.solve(system, columns.len());
    let names = columns
        .iter()
        .map(|column| (column.name(model), column.place));
    let names: Vec<(String, Extent)> = names.collect();
    check_determined(work, &names, &elimination, |_| OF_DRIVES, errors)?;
    let labels = &mut work.labels;
    for ((name, _), value) in names.iter().zip(&elimination.values) {
        labels.name(*value, name.replace('.', "_"));
    }
    for (column, reciprocal) in &elimination.pivots {
        labels.divide_for(*reciprocal, names[*column].0.clone());
    }
    let mut vectors = Vec::new();
    for drive in &model.drives {
        let mut whole = Vector::ZERO;
        let own = columns.iter().zip(&elimination.values);
        for (column, value) in own.filter(|(column, _)| column.load.name == drive.name) {
            let part = work.scale(*value, column.direction);
            whole = work.add(whole, part);
        }
        vectors.push(whole);
    }
    Some(vectors)
}

impl Column<'_> {
    fn name(&self, model: &Model) -> String {
        self.load.component_name(model.motion, self.axis)
    }

    fn turning(&self, model: &Model, work: &Workspace) -> (String, Extent, Components) {
        let moment = work.part(self.moment, Frame::WORLD);
        (self.name(model), self.place, moment)
    }
}

fn columns<'m, 'p>(
    model: &'m Model,
    work: &mut Workspace,
    pushes: impl Iterator<Item = &'p Push>,
) -> Vec<Column<'m>> {
    let center = model.state.center(work);
    let reactions = pushes.map(|push| Column {
        load: &model.reactions[push.reaction],
        axis: push.axis,
        place: push.place,
        direction: push.direction,
        force: push.load.0,
        moment: push.load.1,
    });
    let mut columns: Vec<Column<'m>> = reactions.collect();
    for drive in &model.drives {
        for (axis, place) in &drive.unknown {
            let direction = drive.direction(work, *axis);
            let (force, moment) = match drive.kind {
                LoadKind::Moment => (Vector::ZERO, direction),
                LoadKind::Force => {
                    let arm = arm(model, work, drive.point, center);
                    (direction, work.cross(arm, direction))
                }
            };
            columns.push(Column {
                load: drive,
                axis: *axis,
                place: *place,
                direction,
                force,
                moment,
            });
        }
    }
    columns
}

/// The balances in which unknowns have a part, if there are as many along some axes: of these, axes in
/// which the coefficients are known early.
fn as_many(
    model: &Model,
    work: &mut Workspace,
    rows: &[Row],
    columns: &[Column<'_>],
    rest: (Vector, Vector),
) -> Option<Vec<Equation>> {
    let (world, body) = (Frame::WORLD, model.state.body);
    // the moments about an axis that is fixed in the body
    let is_hinged = model.motion.is_hinged();
    let mut found = None;
    for frames in [(world, body), (body, body), (world, world), (body, world)] {
        if is_hinged && frames.1 == world {
            continue;
        }
        let equations = balances(work, rows, columns, rest, frames);
        let mut coefficients = equations.iter().flat_map(|one| &one.coefficients);
        let is_early = coefficients.all(|id| work.graph.is_early(*id));
        if equations.len() <= columns.len() && (is_early || found.is_none()) {
            found = Some(equations);
            if is_early {
                break;
            }
        }
    }
    found
}

/// The balances in which unknowns have a part, of forces and of moments in these axes.
fn balances(
    work: &mut Workspace,
    rows: &[Row],
    columns: &[Column<'_>],
    rest: (Vector, Vector),
    (of_forces, of_moments): (Frame, Frame),
) -> Vec<Equation> {
    let along = |work: &mut Workspace, row: &Row, force: Vector, moment: Vector| {
        let (vector, frame) = match row.kind {
            LoadKind::Force => (force, of_forces),
            LoadKind::Moment => (moment, of_moments),
        };
        let components = work.components(vector, frame);
        work.graph.dot(row.direction, components)
    };
    let mut system = Vec::new();
    for row in rows {
        let each = columns.iter();
        let coefficients: Vec<Id> = each
            .map(|column| along(work, row, column.force, column.moment))
            .collect();
        if all_vanish(work, &coefficients) {
            continue;
        }
        let rest = along(work, row, rest.0, rest.1);
        system.push((coefficients, work.graph.negate(rest)));
    }
    equations(work, system)
}

/// Gauss's principle, and the balances that hold the body.
fn nearest(
    model: &Model,
    work: &mut Workspace,
    held: &[Row],
    columns: &[Column<'_>],
    rest: (Vector, Vector),
) -> Vec<Equation> {
    let is_in_body = |column: &Column<'_>| work.is_in(column.force, model.state.body);
    // a mass is the same in all axes
    let of_forces = if model.motion.has_attitude() && columns.iter().all(is_in_body) {
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
    let loads: Vec<Pair> = columns
        .iter()
        .map(|column| in_axes(work, column.force, column.moment))
        .collect();
    let frames = (Frame::WORLD, Frame::WORLD);
    let mut system = balances(work, held, columns, rest, frames);
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
