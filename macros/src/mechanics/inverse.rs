//! Inverse dynamics: the drives that go with a given motion.
//!
//! The same balances as in [`super::reactions`], with the accelerations given and the drives unknown
//! beside the reactions. A motion is taken to be one that the drives can make: a balance in which no
//! unknown has a part is not looked at.

use crate::errors::Errors;
use crate::model::{Frame, LoadKind, Meaning, Model, Output};
use crate::symbolic::{Components, Id, Node};

use super::reactions::{ReactionExpressions, Row, Unmoved, balances_left, solve_unknowns};

/// Solves for the drives, each in the axes in which it is written.
pub fn derive_inverse(model: &mut Model, errors: &mut Errors) -> Option<Vec<ReactionExpressions>> {
    if !model.outputs.contains(&Output::Inverse) {
        return Some(Vec::new());
    }
    let mut rows = free_balances(model);
    if !model.reactions.is_empty() {
        rows.extend(balances_left(model));
    }
    let (linear, angular) = given_accelerations(model);
    let reactions = model.reactions.len();
    let mut drives = std::mem::take(&mut model.drives);
    model.reactions.append(&mut drives);
    let solved = solve_unknowns(model, rows, &linear, &angular, Unmoved::Ignored, errors);
    model.drives = model.reactions.split_off(reactions);
    let solved = solved?.split_off(reactions);
    let frames: Vec<Frame> = model.drives.iter().map(|drive| drive.frame).collect();
    let names: Vec<String> = model
        .drives
        .iter()
        .map(|drive| drive.name.to_string())
        .collect();
    let in_own_axes = solved.into_iter().zip(frames.into_iter().zip(names));
    let drives = in_own_axes.map(|(vector, (frame, name))| {
        let components = model.frames.components(vector, frame);
        let vector = model.frames.graph.results(components);
        model.frames.labels.vector(&name, vector);
        ReactionExpressions { vector }
    });
    Some(drives.collect())
}

/// The balances along the directions in which the body moves freely.
fn free_balances(model: &mut Model) -> Vec<Row> {
    let graph = &mut model.frames.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = |axis: usize| [0, 1, 2].map(|i| if i == axis { one } else { zero });
    let along = |kind: LoadKind, direction: Components| Row::new("the balances", kind, direction);
    let mut rows = Vec::new();
    if model.motion.translates() {
        rows.extend((0..model.motion.axes()).map(|axis| along(LoadKind::Force, unit(axis))));
    }
    if let Some(d) = model.hinge() {
        rows.push(along(LoadKind::Moment, d));
    } else if model.motion.has_attitude() {
        let axes = if model.motion.is_planar() { 2..3 } else { 0..3 };
        rows.extend(axes.map(|axis| along(LoadKind::Moment, unit(axis))));
    }
    rows
}

/// The symbols of the accelerations; that of a hinge stands in the place of z.
fn given_accelerations(model: &mut Model) -> (Components, Components) {
    let state = &model.state;
    let roots = [
        state.acceleration.body,
        state.acceleration.world,
        state.angular_acceleration,
    ]
    .concat();
    let zeros = model.frames.graph.zeros();
    let (mut linear, mut angular) = (zeros, zeros);
    let graph = &model.frames.graph;
    for id in graph.reachable(&roots, |_: Id| true) {
        let Node::Symbol(symbol) = graph.node(id) else {
            continue;
        };
        match model.meanings.of(*symbol) {
            Meaning::LinearAcceleration(axis) => linear[axis] = id,
            Meaning::AngularAcceleration(axis) => angular[axis] = id,
            _ => {}
        }
    }
    (linear, angular)
}
