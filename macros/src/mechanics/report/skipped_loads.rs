//! Parts of loads that do not appear in the equations: moments that vanish, sums that are computed
//! before the state is known, parts of the rotation that are not used.

use crate::mechanics::balances::{is_along_axis, is_diagonal, resultant};
use crate::model::{AXES, Attitude, Frame, Inertia, Load, Model, Pair, Workspace};
use crate::symbolic::{Id, Node};

pub fn skip_loads(
    model: &Model,
    work: &mut Workspace,
    accelerations: Pair,
    skipped: &mut Vec<String>,
) {
    skip_resultant(model, work, skipped);
    skip_moments(model, work, skipped);
    skip_potentials(model, skipped);
    merge_charges(model, skipped);
    merge_constants(model, work, skipped);
    skip_rotation(model, work, &accelerations.entries(), skipped);
    skip_mass(model, work, &accelerations.entries(), skipped);
}

/// Mentions forces that add up to zero, so that only a couple remains.
fn skip_resultant(model: &Model, work: &mut Workspace, skipped: &mut Vec<String>) {
    let acts = |load: &Load| !load.force.is_zero();
    if !model.motion.translates() || !model.loads.iter().any(acts) {
        return;
    }
    let sum = resultant(work, &model.loads);
    if model.constraints.is_empty() && sum.is_zero() {
        skipped.push("the acceleration of G: the sum of the forces is zero".to_owned());
    }
}

fn skip_moments(model: &Model, work: &mut Workspace, skipped: &mut Vec<String>) {
    if !model.motion.has_attitude() {
        return;
    }
    let (held, center) = match model.state.support {
        Some(support) => (support.offset, "the point that is held"),
        None => (work.graph.zeros(), "G"),
    };
    for load in &model.loads {
        let force = load.force;
        let Some(offset) = load.point.offset(model.state.body) else {
            continue;
        };
        if load.potential.is_some() || force.is_zero() {
            continue;
        }
        let (in_body, in_world) = (
            work.part(force, model.state.body),
            work.part(force, Frame::WORLD),
        );
        let graph = &mut work.graph;
        let arm = graph.subtract_vectors(offset, held);
        let moment = graph.cross(arm, in_body);
        let reason = if graph.is_zero_vector(&arm) {
            format!("it acts at {center}")
        } else if graph.is_zero_vector(&in_world) && graph.is_zero_vector(&moment) {
            format!("it acts along a line through {center}")
        } else if is_along_axis(model, work, in_world) {
            "it acts along the axis".to_owned()
        } else {
            continue;
        };
        let name = &load.name;
        skipped.push(format!("the moment of `{name}`: {reason}"));
    }
}

/// Mentions that a potential has no force or moment along variables that it does not contain.
fn skip_potentials(model: &Model, skipped: &mut Vec<String>) {
    let derived = model.loads.iter().filter(|load| load.potential.is_some());
    for load in derived {
        let parts = [
            (
                model.motion.knows_position(),
                load.force,
                "force",
                "position",
            ),
            (
                model.motion.has_attitude(),
                load.moment,
                "moment",
                if model.motion.is_line() {
                    "axis"
                } else {
                    "attitude"
                },
            ),
        ];
        for (there, vector, part, place) in parts {
            if there && vector.is_zero() {
                let name = &load.name;
                skipped.push(format!(
                    "the {part} of `{name}`: its potential does not depend on the {place}"
                ));
            }
        }
    }
}

/// Mentions that a uniform field acts only on the sum of the charges and on their dipole (34.9).
fn merge_charges(model: &Model, skipped: &mut Vec<String>) {
    for potential in &model.potentials.list {
        if let Some(charges) = potential.charges.filter(|charges| charges.count > 1) {
            skipped.push(format!(
                "the {} charges of `{}` one by one: they are one charge and one dipole",
                charges.count, potential.name
            ));
        }
    }
}

/// Mentions loads that are the same in all states and are therefore added in advance.
fn merge_constants(model: &Model, work: &mut Workspace, skipped: &mut Vec<String>) {
    if model.motion.is_line() {
        return;
    }
    let (turns, body) = (model.motion.has_attitude(), model.state.body);
    let count = |frame: Frame| {
        let constant = |load: &&Load| is_constant(model, work, load, frame);
        model.loads.iter().filter(constant).count()
    };
    let (in_body, in_world) = (count(body), count(Frame::WORLD));
    for (count, axes) in [(in_body, "body"), (in_world, "world")] {
        if count > 1 {
            let sum = if turns && axes == "body" {
                "one force and one moment"
            } else {
                "one force"
            };
            skipped.push(format!(
                "{count} loads one by one: constant in {axes} axes, they are {sum}"
            ));
        }
    }
    let is_folded = match model.inertia {
        Inertia::Absent => false,
        Inertia::Scalar(_) => true,
        Inertia::Spatial(rows) => model.motion.is_hinged() || is_diagonal(&work.graph, &rows),
    };
    let has_moment = |load: &Load| {
        let (Some(offset), graph) = (load.point.offset(body), &work.graph) else {
            return false;
        };
        is_constant(model, work, load, body)
            && !(graph.is_zero_vector(&offset) && load.moment.is_zero())
    };
    if turns && is_folded && model.state.support.is_none() && model.loads.iter().any(has_moment) {
        skipped.push(
            "constant moments in the balance: over the inertia they are constants".to_owned(),
        );
    }
}

/// Whether the force or moment of a load, in these axes, is known before the state is. In world
/// axes, the load must also be a force at G.
fn is_constant(model: &Model, work: &Workspace, load: &Load, frame: Frame) -> bool {
    let graph = &work.graph;
    let Some(offset) = load.point.offset(model.state.body) else {
        return false;
    };
    let acts = !(load.force.is_zero() && load.moment.is_zero());
    let is_alone = work.is_in(load.force, frame) && work.is_in(load.moment, frame);
    let is_at_center = load.moment.is_zero() && graph.is_zero_vector(&offset);
    let is_early = graph.are_early(&work.entries(&[load.force, load.moment]));
    load.potential.is_none()
        && acts
        && is_alone
        && is_early
        && (frame == model.state.body || is_at_center)
}

/// Mentions unused parts of the rotation: vectors along a body axis need only one column of it, and
/// vectors along a world axis only one row.
fn skip_rotation(model: &Model, work: &mut Workspace, roots: &[Id], skipped: &mut Vec<String>) {
    if !matches!(work.attitude(model.state.body), Attitude::Quaternion { .. }) {
        return;
    }
    let turns = work.turned.clone();
    let graph = &mut work.graph;
    let reachable = graph.nodes_of(roots);
    let parts = [
        (Frame::WORLD, "columns", "body"),
        (model.state.body, "rows", "world"),
    ];
    for (to, lines, axes) in parts {
        let mut along = [false; 3];
        for turn in turns.iter().filter(|turn| turn.to == to) {
            // without the factor that the expression is multiplied by
            let late = turn.turned.map(|part| {
                let (_, magnitude) = graph.split_sign(part);
                graph.split_factor(magnitude).1
            });
            let is_used = |id: &Id| !graph.is_early(*id) && reachable.binary_search(id).is_ok();
            if late.iter().any(is_used) {
                for (there, part) in along.iter_mut().zip(turn.vector) {
                    *there |= !graph.is_zero(part);
                }
            }
        }
        let along: Vec<&str> = AXES
            .into_iter()
            .zip(along)
            .filter(|(_, there)| *there)
            .map(|(axis, _)| axis)
            .collect();
        if let [axis] = along.as_slice() {
            skipped.push(format!(
                "two {lines} of the rotation: what turns is along {axis} in {axes} axes"
            ));
        }
    }
}

/// Mentions a mass that is a parameter, if no acceleration depends on it.
fn skip_mass(model: &Model, work: &Workspace, roots: &[Id], skipped: &mut Vec<String>) {
    let graph = &work.graph;
    let Some(mass) = model.mass else {
        return;
    };
    let symbols = |roots: &[Id]| {
        let mut symbols = graph.nodes_of(roots);
        symbols.retain(|id| matches!(graph.node(*id), Node::Symbol(_)));
        symbols
    };
    let (of_mass, read) = (symbols(&[mass]), symbols(roots));
    if !of_mass.is_empty() && of_mass.iter().all(|symbol| !read.contains(symbol)) {
        skipped.push("the mass: it cancels in the accelerations".to_owned());
    }
}
