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
use crate::model::{Frame, Inertia, LoadKind, Meaning, Model, Point, Vector};
use crate::symbolic::{Components, Equation, Graph, Id, Node, Solution};

use super::newton_euler::{arm, inertia_about_center, moments_about, resultant};
use super::solvability::{check_solution, check_workless};

/// One reaction, as a whole.
pub struct ReactionExpressions {
    /// World axes.
    pub vector: Components,
}

/// An unknown component: its reaction, its axis in the frame of the equations, and its place.
pub struct Unknown {
    pub reaction: usize,
    pub axis: usize,
    pub place: Extent,
}

/// A row of the balances that is left over.
pub struct Row {
    pub name: &'static str,
    /// Of a force or of a moment, from the components of the resultants.
    pub kind: LoadKind,
    pub direction: Components,
}

impl Row {
    pub fn new(name: &'static str, kind: LoadKind, direction: Components) -> Self {
        Self {
            name,
            kind,
            direction,
        }
    }

    /// Of the components of a force and of a moment, those that it is about.
    pub fn of(&self, force: Components, moment: Components) -> Components {
        match self.kind {
            LoadKind::Force => force,
            LoadKind::Moment => moment,
        }
    }
}

/// Solves for the unknown components; what they cannot be solved for is reported on them.
pub fn derive_reactions(
    model: &mut Model,
    linear: &Components,
    angular: &Components,
    errors: &mut Errors,
) -> Option<Vec<ReactionExpressions>> {
    if model.reactions.is_empty() {
        return Some(Vec::new());
    }
    check_workless(model, errors)?;
    let rows = balances_left(model);
    let solved = match solve_unknowns(model, rows, linear, angular, Unmoved::Checked) {
        Ok(solved) => solved,
        Err(place) => {
            errors.push(place, "in world axes the part of this reaction that is known turns against the body: write it in body axes, or leave all its components unknown");
            return None;
        }
    };
    check_solution(model, &solved, errors)?;
    let solved = assemble(model, &solved);
    let names: Vec<String> = model
        .reactions
        .iter()
        .map(|reaction| reaction.name.to_string())
        .collect();
    let in_world = solved.into_iter().zip(names).map(|(whole, name)| {
        let vector = model.frames.components(whole, Frame::World);
        let vector = model.frames.graph.results(vector);
        model.frames.labels.vector(&name, vector);
        ReactionExpressions { vector }
    });
    Some(in_world.collect())
}

/// What is done with balances in which no unknown has a part.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Unmoved {
    /// They have to hold by themselves.
    Checked,
    /// The motion is taken to meet them.
    Ignored,
}

/// What the balances say of the unknowns.
pub struct Solved {
    frame: Frame,
    pub unknowns: Vec<Unknown>,
    pub rows: Vec<Row>,
    pub solution: Solution,
    /// Whether the coefficients are known before the state is.
    pub is_constant: bool,
}

/// The unknown loads that meet the balances of `rows`, in a motion with these accelerations. Where
/// coefficients are not constant in any axes, the place of an unknown that makes them so.
pub fn solve_unknowns(
    model: &mut Model,
    mut rows: Vec<Row>,
    linear: &Components,
    angular: &Components,
    unmoved: Unmoved,
) -> Result<Solved, Extent> {
    let frame = choose_frame(model)?;
    let unknowns = list_unknowns(model);
    if unmoved == Unmoved::Ignored {
        rows.retain(|row| {
            let mut coefficients = unknowns.iter();
            coefficients.any(|unknown| {
                let coefficient = coefficient(model, frame, row, unknown);
                !model.frames.graph.vanishes(coefficient)
            })
        });
    }
    let (force, moment) = balances_without_unknowns(model, linear, angular);
    let (force, moment) = (
        model.frames.components(force, frame),
        model.frames.components(moment, frame),
    );
    let mut equations = Vec::new();
    for row in &rows {
        let coefficients = unknowns
            .iter()
            .map(|unknown| coefficient(model, frame, row, unknown))
            .collect();
        let graph = &mut model.frames.graph;
        let known = graph.dot(row.direction, row.of(force, moment));
        let right = graph.negate(known);
        equations.push(Equation {
            coefficients,
            right,
        });
    }
    let mut coefficients = equations.iter().flat_map(|row| &row.coefficients);
    let is_constant = coefficients.all(|id| model.frames.graph.is_early(*id));
    let solution = model.frames.graph.solve(equations, unknowns.len());
    Ok(Solved {
        frame,
        unknowns,
        rows,
        solution,
        is_constant,
    })
}

/// The axes in which the balances are written: those of the world where all unknowns can be written
/// in them with constant coefficients, else those of the body. All three components of an unknown
/// vector can be written in any axes.
fn choose_frame(model: &mut Model) -> Result<Frame, Extent> {
    let center = model.state.center(&mut model.frames);
    let mut in_world = true;
    let mut mixed = None;
    for index in 0..model.reactions.len() {
        let is_free = is_in_any_axes(model, index);
        let reaction = &model.reactions[index];
        let (point, kind, written) = (reaction.point, reaction.kind, reaction.frame);
        let place = reaction.unknown.first().map(|(_, place)| *place);
        if let (Some(_), Some(place)) = (reaction.along, place) {
            return Err(place);
        }
        let arm = arm(model, point, center);
        let has_arm = kind == LoadKind::Force && !model.frames.is_zero_vector(arm);
        in_world &= !has_arm && (is_free || written == Frame::World);
        if !is_free && written == Frame::World {
            mixed = mixed.or(place);
        }
    }
    // without an attitude the axes are the same
    if in_world || !model.motion.has_attitude() {
        return Ok(Frame::World);
    }
    mixed.map_or(Ok(Frame::Body), Err)
}

/// Whether the unknown components of a reaction are the same unknowns in the axes of the body and
/// in those of the world: all of them, and, about an axis of coordinates, that along it or those
/// across it.
fn is_in_any_axes(model: &mut Model, index: usize) -> bool {
    let hinge = model.hinge();
    let reaction = &model.reactions[index];
    if reaction.is_whole(model.motion) {
        return true;
    }
    let axes: Vec<usize> = reaction.unknown.iter().map(|(axis, _)| *axis).collect();
    let graph = &model.frames.graph;
    let along = hinge.and_then(|d| (0..3).find(|axis| graph.is_along(d, *axis)));
    along.is_some_and(|along| axes == [along] || (axes.len() == 2 && !axes.contains(&along)))
}

pub fn list_unknowns(model: &Model) -> Vec<Unknown> {
    let reactions = model.reactions.iter().enumerate();
    let all = reactions.flat_map(|(reaction, load)| {
        load.unknown.iter().map(move |(axis, place)| Unknown {
            reaction,
            axis: *axis,
            place: *place,
        })
    });
    all.collect()
}

/// The balances that do not determine the accelerations.
pub fn balances_left(model: &mut Model) -> Vec<Row> {
    let graph = &mut model.frames.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = |axis: usize| [0, 1, 2].map(|i| if i == axis { one } else { zero });
    let mut rows = Vec::new();
    if !model.motion.translates() {
        for axis in 0..model.motion.axes() {
            let name = [
                "the forces along x",
                "the forces along y",
                "the forces along z",
            ][axis];
            rows.push(Row {
                name,
                kind: LoadKind::Force,
                direction: unit(axis),
            });
        }
    }
    let moment_names = [
        "the moments about x",
        "the moments about y",
        "the moments about z",
    ];
    if !model.motion.has_attitude() {
        let axes = if model.motion.is_planar() { 2..3 } else { 0..3 };
        rows.extend(axes.map(|axis| Row {
            name: moment_names[axis],
            kind: LoadKind::Moment,
            direction: unit(axis),
        }));
    } else if let (false, Some(d)) = (model.motion.is_planar(), model.hinge()) {
        rows.extend(across(model, d).map(|(name, direction)| Row {
            name,
            kind: LoadKind::Moment,
            direction,
        }));
    }
    rows
}

/// Two directions across an axis: the other two axes, if it is one of them.
fn across(model: &mut Model, d: Components) -> [(&'static str, Components); 2] {
    let graph = &mut model.frames.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = |axis: usize| [0, 1, 2].map(|i| if i == axis { one } else { zero });
    let along = (0..3).find(|axis| graph.is_along(d, *axis));
    if let Some(axis) = along {
        let name = |axis: usize| {
            [
                "the moments about x",
                "the moments about y",
                "the moments about z",
            ][axis]
        };
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        return [(name(i), unit(i)), (name(j), unit(j))];
    }
    let zero_axis = (0..3).find(|axis| graph.is_zero(d[*axis]));
    let first = match zero_axis {
        Some(axis) => unit(axis),
        None => graph.cross(d, unit(0)),
    };
    let second = graph.cross(d, first);
    let name = "the moments across the axis";
    [(name, first), (name, second)]
}

/// Sum of the given forces and their moment about the center, less the inertial ones.
pub fn balances_without_unknowns(
    model: &mut Model,
    linear: &Components,
    angular: &Components,
) -> (Vector, Vector) {
    let center = model.state.center(&mut model.frames);
    let mut force = resultant(model);
    let moments = moments_about(model, center);
    let mut moment = model.frames.sum(moments);
    for (given_force, given_moment) in given_parts(model, center) {
        force = model.frames.add(force, given_force);
        moment = model.frames.add(moment, given_moment);
    }
    let (inertial_force, inertial_moment) = inertial(model, linear, angular);
    let force = model.frames.add(force, inertial_force);
    let moment = model.frames.add(moment, inertial_moment);
    (force, moment)
}

/// What is given of each reaction: its force, and its moment about `pole`.
pub fn given_parts(model: &mut Model, pole: Point) -> Vec<(Vector, Vector)> {
    let written: Vec<_> = model
        .reactions
        .iter()
        .map(|load| (load.kind, load.point, load.frame, load.given))
        .collect();
    let parts = written.into_iter().map(|(kind, point, frame, given)| {
        let given = model.frames.vector(frame, given);
        match kind {
            LoadKind::Moment => (model.frames.zero_vector(), given),
            LoadKind::Force => {
                let arm = arm(model, point, pole);
                (given, model.frames.cross(arm, given))
            }
        }
    });
    parts.collect()
}

/// `-m a` and `-(J_C w' + w x J_C w)`, in the motion that the accelerations give.
fn inertial(model: &mut Model, linear: &Components, angular: &Components) -> (Vector, Vector) {
    let hinge = model.hinge();
    let graph = &mut model.frames.graph;
    let rate = match hinge {
        Some(d) => graph.scale_vector(angular[2], d),
        None => *angular,
    };
    let symbols: Vec<(Id, Id)> = accelerations(model, linear, &rate, angular);
    let acceleration = model.state.acceleration;
    let replaced = |graph: &mut Graph, components: Components| -> Components {
        let images = graph.substitute(&components, |id| {
            symbols
                .iter()
                .find(|(symbol, _)| *symbol == id)
                .map(|(_, value)| *value)
        });
        [images[0], images[1], images[2]]
    };
    let graph = &mut model.frames.graph;
    let acceleration = Vector {
        body: replaced(graph, acceleration.body),
        world: replaced(graph, acceleration.world),
    };
    let zero = model.frames.zero_vector();
    let force = match model.mass {
        Some(mass) => {
            let rate = model.frames.scale(mass, acceleration);
            model.frames.negate(rate)
        }
        None => zero,
    };
    let w = model.state.angular_velocity;
    let inertia = inertia_about_center(model);
    let graph = &mut model.frames.graph;
    let change = match inertia {
        Inertia::Absent => graph.zeros(),
        Inertia::Scalar(moment) => graph.scale_vector(moment, rate),
        Inertia::Spatial(rows) => {
            let momentum = graph.transform(&rows, w);
            let gyroscopic = graph.cross(w, momentum);
            let driven = graph.transform(&rows, rate);
            graph.add_vectors(driven, gyroscopic)
        }
    };
    let change = graph.negate_vector(change);
    let moment = model.frames.vector(Frame::Body, change);
    (force, moment)
}

/// The symbols of the accelerations and the expressions they are.
fn accelerations(
    model: &Model,
    linear: &Components,
    rate: &Components,
    angular: &Components,
) -> Vec<(Id, Id)> {
    let graph = &model.frames.graph;
    let state = &model.state;
    let symbols: Vec<Id> = graph.reachable(
        &[
            state.acceleration.body,
            state.acceleration.world,
            state.angular_acceleration,
        ]
        .concat(),
        |_| true,
    );
    let value = |id: Id| {
        let Node::Symbol(symbol) = graph.node(id) else {
            return None;
        };
        match model.meanings.of(*symbol) {
            Meaning::LinearAcceleration(axis) => Some((id, linear[axis])),
            Meaning::AngularAcceleration(axis) if model.motion.is_hinged() => {
                Some((id, angular[axis]))
            }
            Meaning::AngularAcceleration(axis) => Some((id, rate[axis])),
            _ => None,
        }
    };
    symbols.into_iter().filter_map(value).collect()
}

/// How an unknown enters a row: a force along its axis, and by its arm as a moment.
fn coefficient(model: &mut Model, frame: Frame, row: &Row, unknown: &Unknown) -> Id {
    let (kind, point) = {
        let reaction = &model.reactions[unknown.reaction];
        (reaction.kind, reaction.point)
    };
    let center = model.state.center(&mut model.frames);
    let graph = &mut model.frames.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = [0, 1, 2].map(|axis| if axis == unknown.axis { one } else { zero });
    let part = match (row.kind, kind) {
        (LoadKind::Force, LoadKind::Moment) => return zero,
        (LoadKind::Force, LoadKind::Force) | (LoadKind::Moment, LoadKind::Moment) => unit,
        (LoadKind::Moment, LoadKind::Force) => {
            let arm = arm(model, point, center);
            let arm = model.frames.components(arm, frame);
            model.frames.graph.cross(arm, unit)
        }
    };
    model.frames.graph.dot(row.direction, part)
}

/// Given and solved components together.
pub fn assemble(model: &mut Model, solved: &Solved) -> Vec<Vector> {
    let Solved {
        frame,
        unknowns,
        solution,
        ..
    } = solved;
    let mut vectors = Vec::new();
    for index in 0..model.reactions.len() {
        let (written, given) = {
            let reaction = &model.reactions[index];
            (reaction.frame, reaction.given)
        };
        let mut solved = model.frames.graph.zeros();
        for (unknown, value) in unknowns.iter().zip(&solution.values) {
            if unknown.reaction == index {
                solved[unknown.axis] = *value;
            }
        }
        let (given, solved) = (
            model.frames.vector(written, given),
            model.frames.vector(*frame, solved),
        );
        vectors.push(model.frames.add(given, solved));
    }
    vectors
}
