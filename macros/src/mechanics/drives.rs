//! Drives that enter the balances with coefficients that depend on the configuration.
//!
//! ```text
//! sum of u_j w_j + b = 0      w_j: force and moment of one unit of the unknown j; b: what is left without them
//! ```
//!
//! As many balances as unknowns, along axes in which no other has a part in them, are solved as they
//! are. Where there are more, the motion is taken to be one that the drives can make, and they follow from
//! Gauss's principle, by which the acceleration they leave over is least in the metric of the kinetic energy:
//!
//! ```text
//! sum of (w_i . M^-1 w_j) u_j = -w_i . M^-1 b
//! ```

use crate::errors::{Errors, Extent};
use crate::model::{Frame, LoadKind, Model, Vector};
use crate::symbolic::{self, Components, Elimination, Id, Size};

use super::constraints::component_name;
use super::newton_euler::arm;
use super::reactions::{Row, balances_without_unknowns, list_unknowns};
use super::response::response;
use super::zeros::{all_vanish, samples};

/// One unit of an unknown.
struct Column {
    drive: usize,
    axis: usize,
    place: Extent,
    /// In the axes in which it is written.
    direction: Vector,
    force: Vector,
    /// About the center.
    moment: Vector,
}

/// An equation for the unknowns: coefficients, what they are compared with, and the right side.
struct Equation {
    coefficients: Vec<Id>,
    sizes: Vec<Size>,
    right: Id,
}

/// Solves for the drives, which stand behind `first` reactions in the model. `rows` are the balances
/// along the directions in which the body moves freely.
pub fn solve_drives(
    model: &mut Model,
    first: usize,
    rows: &[Row],
    (linear, angular): (&Components, &Components),
    errors: &mut Errors,
) -> Option<Vec<Vector>> {
    let columns = columns(model, first);
    let rest = balances_without_unknowns(model, linear, angular);
    let equations = match as_many(model, rows, &columns, rest) {
        Some(equations) => equations,
        None => nearest(model, &columns, rest),
    };
    let elimination = eliminate(model, equations, columns.len());
    let names: Vec<String> = columns
        .iter()
        .map(|column| component_name(model, column.drive, column.axis))
        .collect();
    for column in &elimination.undetermined {
        let name = &names[*column];
        let message = if columns.len() == 1 {
            format!("nothing determines `{name}`: it has no part in how the body moves freely")
        } else {
            format!(
                "more is unknown than the balances determine: what `{name}` does, the other drives do \
                 together; write the value of one of them, 0 if it is at rest"
            )
        };
        errors.push(columns[*column].place, message);
    }
    if !elimination.undetermined.is_empty() {
        return None;
    }
    let labels = &mut model.frames.labels;
    for (name, value) in names.iter().zip(&elimination.values) {
        labels.name(*value, name.replace('.', "_"));
    }
    for (column, reciprocal) in &elimination.pivots {
        labels.divide_for(*reciprocal, names[*column].clone());
    }
    let mut vectors = Vec::new();
    for drive in first..model.reactions.len() {
        let mut whole = model.frames.zero_vector();
        let own = columns.iter().zip(&elimination.values);
        for (column, value) in own.filter(|(column, _)| column.drive == drive) {
            let part = model.frames.scale(*value, column.direction);
            whole = model.frames.add(whole, part);
        }
        vectors.push(whole);
    }
    Some(vectors)
}

fn columns(model: &mut Model, first: usize) -> Vec<Column> {
    let center = model.state.center(&mut model.frames);
    let mut columns = Vec::new();
    for unknown in list_unknowns(model) {
        let drive = &model.reactions[unknown.reaction];
        let (kind, point, frame, along) = (drive.kind, drive.point, drive.frame, drive.along);
        if unknown.reaction < first {
            continue;
        }
        let unit = [0, 1, 2].map(|axis| {
            let component = i64::from(axis == unknown.axis);
            model.frames.graph.integer(component)
        });
        let direction = along.unwrap_or_else(|| model.frames.vector(frame, unit));
        let (force, moment) = match kind {
            LoadKind::Moment => (model.frames.zero_vector(), direction),
            LoadKind::Force => {
                let arm = arm(model, point, center);
                (direction, model.frames.cross(arm, direction))
            }
        };
        columns.push(Column {
            drive: unknown.reaction,
            axis: unknown.axis,
            place: unknown.place,
            direction,
            force,
            moment,
        });
    }
    columns
}

/// The balances in which unknowns have a part, if there are as many along some axes.
fn as_many(
    model: &mut Model,
    rows: &[Row],
    columns: &[Column],
    rest: (Vector, Vector),
) -> Option<Vec<Equation>> {
    use Frame::{Body, World};
    // the moments about an axis that is fixed in the body
    let is_hinged = model.motion.is_hinged();
    for (of_forces, of_moments) in [(World, Body), (Body, Body), (World, World), (Body, World)] {
        if is_hinged && of_moments == World {
            continue;
        }
        let along = |model: &mut Model, row: &Row, force: Vector, moment: Vector| {
            let (vector, frame) = match row.kind {
                LoadKind::Force => (force, of_forces),
                LoadKind::Moment => (moment, of_moments),
            };
            let components = model.frames.components(vector, frame);
            model.frames.graph.dot(row.direction, components)
        };
        let mut equations = Vec::new();
        for row in rows {
            let each = columns.iter();
            let coefficients: Vec<Id> = each
                .map(|column| along(model, row, column.force, column.moment))
                .collect();
            if all_vanish(model, &coefficients) {
                continue;
            }
            let rest = along(model, row, rest.0, rest.1);
            equations.push(Equation {
                sizes: vec![Size::Terms; coefficients.len()],
                coefficients,
                right: model.frames.graph.negate(rest),
            });
        }
        if equations.len() <= columns.len() {
            return Some(equations);
        }
    }
    None
}

/// Gauss's principle.
fn nearest(model: &mut Model, columns: &[Column], rest: (Vector, Vector)) -> Vec<Equation> {
    let graph = &model.frames.graph;
    let is_in_body = |column: &Column| graph.is_zero_vector(&column.force.world);
    // a mass is the same in all axes
    let of_forces = if model.motion.has_attitude() && columns.iter().all(is_in_body) {
        Frame::Body
    } else {
        Frame::World
    };
    let in_axes = |model: &mut Model, force: Vector, moment: Vector| {
        let force = model.frames.components(force, of_forces);
        (force, model.frames.components(moment, Frame::Body))
    };
    let loads: Vec<(Components, Components)> = columns
        .iter()
        .map(|column| in_axes(model, column.force, column.moment))
        .collect();
    let rest = in_axes(model, rest.0, rest.1);
    let mut equations = Vec::new();
    for (row, (force, moment)) in loads.iter().enumerate() {
        let (linear, angular) = response(model, *force, *moment);
        let graph = &mut model.frames.graph;
        let mut power = |(force, moment): (Components, Components)| {
            let (first, second) = (graph.dot(linear, force), graph.dot(angular, moment));
            graph.add(first, second)
        };
        let coefficients: Vec<Id> = loads.iter().map(|load| power(*load)).collect();
        let rest = power(rest);
        let size = |column: usize| {
            if column == row {
                Size::Squares
            } else {
                Size::Terms
            }
        };
        equations.push(Equation {
            sizes: (0..coefficients.len()).map(size).collect(),
            coefficients,
            right: model.frames.graph.negate(rest),
        });
    }
    equations
}

fn eliminate(model: &mut Model, equations: Vec<Equation>, unknowns: usize) -> Elimination {
    let all: Vec<Id> = equations
        .iter()
        .flat_map(|equation| equation.coefficients.clone())
        .collect();
    let mut values = samples(model, &all).into_iter();
    let rows = equations.into_iter().map(|equation| symbolic::Row {
        sample: values.by_ref().take(unknowns).collect(),
        coefficients: equation.coefficients,
        active: None,
        sizes: equation.sizes,
        right: equation.right,
    });
    let rows = rows.collect();
    model.frames.graph.solve_guarded(rows, unknowns)
}
