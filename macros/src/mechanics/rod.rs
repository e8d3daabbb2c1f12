//! (1.4) of a rod: without inertia about its axis u, it turns as u does (EQUATIONS.md, D).
//!
//! ```text
//! u'' = (K x u) / J - u'^2 u
//! ```
//!
//! K is perpendicular to u. Forces on the axis, at s u from G, have `K x u = B - (u . B) u` with their
//! first moment `B = sum of s F`, so that one projection is enough, and none if only couples act:
//!
//! ```text
//! u'' = B / J - (u . B / J + u'^2) u
//! ```

use crate::errors::{Errors, Extent};
use crate::model::{Attitude, Axis, Frame, Inertia, Model, Point, Vector};
use crate::symbolic::{Components, Id, Number};

use super::newton_euler::{arm, moments_about};
use super::pushes::Push;
use super::samples::sample;

/// u'' by the loads of the model, world axes.
pub fn axis_acceleration(model: &mut Model, axis: Axis) -> Components {
    let Inertia::Scalar(inertia) = model.inertia else {
        return model.frames.graph.zeros();
    };
    let (first_moment, couple) = resultants(model);
    let Axis { unit, rate } = axis;
    let graph = &mut model.frames.graph;
    let one = graph.one();
    let inverse = graph.divide(one, inertia);
    let driving = first_moment.map(|part| graph.distribute(inverse, part));
    let driving = graph.quantities(driving);
    let couple = couple.map(|part| graph.distribute(inverse, part));
    let turning = graph.cross(couple, unit);
    let along = graph.dot(unit, driving);
    let square = graph.norm_squared(rate);
    let holding = graph.add(along, square);
    let holding = graph.quantity(holding);
    let held = graph.scale_vector(holding, unit);
    let driven = graph.add_vectors(driving, turning);
    let acceleration = graph.subtract_vectors(driven, held);
    let acceleration = graph.results(acceleration);
    let labels = &mut model.frames.labels;
    labels.name(inverse, "inverse_inertia");
    labels.describe(
        "driving",
        "B / J: first moment of the forces on the axis, sum of s F, over J",
    );
    labels.vector("driving", driving);
    labels.describe("holding", "u.B / J + u'^2: it keeps the length of u");
    labels.name(holding, "holding");
    name_acceleration(model, acceleration);
    acceleration
}

/// The first moment of the forces that act on the axis, and the moment of all else.
fn resultants(model: &mut Model) -> (Components, Components) {
    let (mut first_moments, mut couples) = (Vec::new(), Vec::new());
    let center = Point::Body(model.frames.graph.zeros());
    let loads: Vec<_> = model
        .loads
        .iter()
        .map(|load| (load.force, load.point, load.moment, load.pull))
        .collect();
    for (force, point, moment, pull) in loads {
        if let (Point::Body(offset), Attitude::Line { direction, .. }) =
            (point, model.frames.attitude)
        {
            let along = model.frames.graph.dot(direction, offset);
            if !is_along_axis(model, force) {
                first_moments.push(model.frames.scale(along, force));
            }
        } else if !model.frames.is_zero_vector(force) {
            let arm = arm(model, point, center);
            couples.push(model.frames.cross(arm, force));
        }
        match pull {
            Some(pull) => first_moments.push(model.frames.vector(Frame::World, pull)),
            None => couples.push(moment),
        }
    }
    let mut total = |vectors: Vec<Vector>| {
        let sum = model.frames.sum(vectors);
        model.frames.components(sum, Frame::World)
    };
    (total(first_moments), total(couples))
}

/// Whether a force is along the axis in all states: on it, it has no moment.
pub fn is_along_axis(model: &mut Model, force: Vector) -> bool {
    let Some(Axis { unit, .. }) = model.state.axis else {
        return false;
    };
    let force = model.frames.components(force, Frame::World);
    let moment = model.frames.graph.cross(unit, force);
    sample(model, &moment).iter().all(Number::is_zero)
}

/// `u'' = w' x u - u'^2 u`
pub fn of_angular(model: &mut Model, axis: Axis, angular: Components) -> Components {
    let change = turned_by(model, axis, angular);
    let graph = &mut model.frames.graph;
    let square = graph.norm_squared(axis.rate);
    let held = graph.scale_vector(square, axis.unit);
    let acceleration = graph.subtract_vectors(change, held);
    let acceleration = graph.results(acceleration);
    name_acceleration(model, acceleration);
    acceleration
}

/// How u changes by a turn: `phi x u`.
pub fn turned_by(model: &mut Model, axis: Axis, turn: Components) -> Components {
    model.frames.graph.cross(turn, axis.unit)
}

fn name_acceleration(model: &mut Model, acceleration: Components) {
    let labels = &mut model.frames.labels;
    labels.describe("axis", "(1.4), world axes: u'' = (K x u) / J - u'^2 u");
    labels.vector("axis", acceleration);
}

/// Nothing balances a moment about the axis.
pub fn check_loads(model: &mut Model, axis: Axis, errors: &mut Errors) -> Option<()> {
    let center = Point::Body(model.frames.graph.zeros());
    let moments: Vec<(Extent, Id)> = moments_about(model, center)
        .into_iter()
        .enumerate()
        .map(|(index, moment)| {
            let moment = model.frames.components(moment, Frame::World);
            let along = model.frames.graph.dot(axis.unit, moment);
            (model.loads[index].extent, along)
        })
        .collect();
    let parts: Vec<Id> = moments.iter().map(|(_, along)| *along).collect();
    let together = model.frames.graph.sum(&parts);
    if sample(model, &[together])[0].is_zero() {
        return Some(());
    }
    let values = sample(model, &parts);
    let wrong: Vec<usize> = turning(&values);
    for index in wrong {
        let name = &model.loads[index].name;
        errors.push(
            moments[index].0,
            format!(
                "`{name}` has a moment about the axis, about which a rod has no inertia: let it act on \
                 the axis, or take what is across it, as in `axis.cross(k).cross(axis)`"
            ),
        );
    }
    None
}

/// The same of one unit of each unknown.
pub fn check_pushes(
    model: &mut Model,
    axis: Axis,
    pushes: &[Push],
    errors: &mut Errors,
) -> Option<()> {
    let graph = &mut model.frames.graph;
    let parts: Vec<Id> = pushes
        .iter()
        .map(|push| graph.dot(axis.unit, push.body_moment))
        .collect();
    let values = sample(model, &parts);
    let wrong = turning(&values);
    for index in &wrong {
        let name = pushes[*index].name(model);
        errors.push(
            pushes[*index].place,
            format!(
                "`{name}` has a moment about the axis, about which a rod has no inertia: let it act on \
                 the axis, or write a direction across it, as in `_ * axis.cross(k)`"
            ),
        );
    }
    wrong.is_empty().then_some(())
}

fn turning(values: &[Number]) -> Vec<usize> {
    (0..values.len())
        .filter(|index| !values[*index].is_zero())
        .collect()
}
