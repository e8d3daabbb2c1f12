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
use crate::model::{Frame, Inertia, LoadKind, Meaning, Model, Point, Reaction, Vector, Workspace};
use crate::symbolic::{Components, Equation, Graph, Id, Node, Solution};

use super::newton_euler::{arm, inertia_about_center, moments_about, resultant};
use super::solvability::{check_solution, check_workless};

/// An unknown component: its load, its axis in the frame of the equations, and its place.
pub struct Unknown<'m> {
    pub load: &'m Reaction,
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
    model: &Model,
    work: &mut Workspace,
    linear: &Components,
    angular: &Components,
    errors: &mut Errors,
) -> Option<Vec<Components>> {
    if model.reactions.is_empty() {
        return Some(Vec::new());
    }
    check_workless(model, work, errors)?;
    let rows = balances_left(model, work);
    let unknown: Vec<&Reaction> = model.reactions.iter().collect();
    let solved = match solve_unknowns(
        model,
        work,
        &unknown,
        rows,
        (linear, angular),
        Unmoved::Checked,
    ) {
        Ok(solved) => solved,
        Err(place) => {
            errors.push(place, "in world axes the part of this reaction that is known turns against the body: write it in body axes, or leave all its components unknown");
            return None;
        }
    };
    check_solution(model, work, &solved, errors)?;
    let in_world = unknown.into_iter().map(|reaction| {
        let whole = assemble(work, &solved, reaction);
        let vector = work.components(whole, Frame::World);
        let vector = work.graph.results(vector);
        work.labels.vector(&reaction.name.to_string(), vector);
        vector
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
pub struct Solved<'m> {
    frame: Frame,
    pub unknowns: Vec<Unknown<'m>>,
    pub rows: Vec<Row>,
    pub solution: Solution,
    /// Whether the coefficients are known before the state is.
    pub is_constant: bool,
}

/// The components of unknown loads that meet the balances of `rows`, in a motion with these accelerations. Where
/// coefficients are not constant in any axes, the place of an unknown that makes them so.
pub fn solve_unknowns<'m>(
    model: &Model,
    work: &mut Workspace,
    loads: &[&'m Reaction],
    mut rows: Vec<Row>,
    (linear, angular): (&Components, &Components),
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
    let (force, moment) = balances_without_unknowns(model, work, linear, angular);
    let (force, moment) = (
        work.components(force, frame),
        work.components(moment, frame),
    );
    let mut equations = Vec::new();
    for row in &rows {
        let coefficients = unknowns
            .iter()
            .map(|unknown| coefficient(model, work, frame, row, unknown))
            .collect();
        let graph = &mut work.graph;
        let known = graph.dot(row.direction, row.of(force, moment));
        let right = graph.negate(known);
        equations.push(Equation {
            coefficients,
            right,
        });
    }
    let mut coefficients = equations.iter().flat_map(|row| &row.coefficients);
    let is_constant = coefficients.all(|id| work.graph.is_early(*id));
    let solution = work.graph.solve(equations, unknowns.len());
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
        let has_arm = kind == LoadKind::Force && !work.is_zero_vector(arm);
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

/// The balances that do not determine the accelerations.
pub fn balances_left(model: &Model, work: &mut Workspace) -> Vec<Row> {
    let graph = &mut work.graph;
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
    } else if let (false, Some(d)) = (model.motion.is_planar(), model.hinge(&mut work.graph)) {
        rows.extend(across(work, d).map(|(name, direction)| Row {
            name,
            kind: LoadKind::Moment,
            direction,
        }));
    }
    rows
}

/// Two directions across an axis: the other two axes, if it is one of them.
fn across(work: &mut Workspace, d: Components) -> [(&'static str, Components); 2] {
    let graph = &mut work.graph;
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
    model: &Model,
    work: &mut Workspace,
    linear: &Components,
    angular: &Components,
) -> (Vector, Vector) {
    let center = model.state.center(work);
    let mut force = resultant(work, &model.loads);
    let moments = moments_about(model, work, &model.loads, center);
    let mut moment = work.sum(moments);
    for (given_force, given_moment) in given_parts(model, work, center) {
        force = work.add(force, given_force);
        moment = work.add(moment, given_moment);
    }
    let (inertial_force, inertial_moment) = inertial(model, work, linear, angular);
    let force = work.add(force, inertial_force);
    let moment = work.add(moment, inertial_moment);
    (force, moment)
}

/// What is given of each reaction: its force, and its moment about `pole`.
pub fn given_parts(model: &Model, work: &mut Workspace, pole: Point) -> Vec<(Vector, Vector)> {
    let written: Vec<_> = model
        .reactions
        .iter()
        .map(|load| (load.kind, load.point, load.frame, load.given))
        .collect();
    let parts = written.into_iter().map(|(kind, point, frame, given)| {
        let given = work.vector(frame, given);
        match kind {
            LoadKind::Moment => (work.zero_vector(), given),
            LoadKind::Force => {
                let arm = arm(model, work, point, pole);
                (given, work.cross(arm, given))
            }
        }
    });
    parts.collect()
}

/// `-m a` and `-(J_C w' + w x J_C w)`, in the motion that the accelerations give.
fn inertial(
    model: &Model,
    work: &mut Workspace,
    linear: &Components,
    angular: &Components,
) -> (Vector, Vector) {
    let hinge = model.hinge(&mut work.graph);
    let graph = &mut work.graph;
    let rate = match hinge {
        Some(d) => graph.scale_vector(angular[2], d),
        None => *angular,
    };
    let symbols: Vec<(Id, Id)> = accelerations(model, work, linear, &rate, angular);
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
    let graph = &mut work.graph;
    let acceleration = Vector {
        body: replaced(graph, acceleration.body),
        world: replaced(graph, acceleration.world),
    };
    let zero = work.zero_vector();
    let force = match model.mass {
        Some(mass) => {
            let rate = work.scale(mass, acceleration);
            work.negate(rate)
        }
        None => zero,
    };
    let w = model.state.angular_velocity;
    let inertia = inertia_about_center(model, work);
    let graph = &mut work.graph;
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
    let moment = work.vector(Frame::Body, change);
    (force, moment)
}

/// The symbols of the accelerations and the expressions they are.
fn accelerations(
    model: &Model,
    work: &Workspace,
    linear: &Components,
    rate: &Components,
    angular: &Components,
) -> Vec<(Id, Id)> {
    let graph = &work.graph;
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
        match work.meanings.of(*symbol) {
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
    for (unknown, value) in solved.unknowns.iter().zip(&solved.solution.values) {
        if unknown.load.name == load.name {
            components[unknown.axis] = *value;
        }
    }
    let given = work.vector(load.frame, load.given);
    let solved = work.vector(solved.frame, components);
    work.add(given, solved)
}
