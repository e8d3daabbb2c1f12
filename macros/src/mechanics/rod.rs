//! (1.4) of a rod: without inertia about its axis u, it turns as u does.
//!
//! ```text
//! u'' = (K x u) / J - u'^2 u
//! ```
//!
//! All vectors are in world axes, and K is perpendicular to u. Where it is `u x B`, of forces with the
//! first moment `B = sum of s F`, of potentials and of most couples that can be written,
//! `K x u = B - (u . B) u`: these are summed, and one projection is enough; none where B is across the
//! axis already, as that of damping is.
//!
//! ```text
//! u'' = B / J - (u . B / J + u'^2) u
//! ```

use crate::errors::{Errors, Extent};
use crate::model::{Attitude, Axis, Inertia, Model, Point};
use crate::symbolic::{Components, Id};

use super::newton_euler::{arm, moments_about};
use super::pushes::Push;
use super::zeros::{all_vanish, samples};

/// u'' by the loads of the model, world axes.
pub fn axis_acceleration(model: &mut Model, axis: Axis) -> Components {
    let Inertia::Scalar(inertia) = model.inertia else {
        return model.frames.graph.zeros();
    };
    let Pulls { any, across } = pulls(model, axis);
    let Axis { unit, rate } = axis;
    let graph = &mut model.frames.graph;
    let one = graph.one();
    let inverse = graph.divide(one, inertia);
    let mut over_inertia = |vector: Components| vector.map(|part| graph.distribute(inverse, part));
    let (driving, across) = (over_inertia(any), over_inertia(across));
    let driving = graph.quantities(driving);
    let along = graph.dot(unit, driving);
    let square = graph.norm_squared(rate);
    let holding = graph.add(along, square);
    let holding = graph.quantity(holding);
    let held = graph.scale_vector(holding, unit);
    let driven = graph.add_vectors(driving, across);
    let acceleration = graph.subtract_vectors(driven, held);
    let acceleration = graph.results(acceleration);
    let labels = &mut model.frames.labels;
    labels.name(inverse, "inverse_inertia");
    labels.describe("driving", "B / J, world axes: of forces, B = sum of s F");
    labels.vector("driving", driving);
    labels.describe("holding", "u.B / J + u'^2: it keeps the length of u");
    labels.name(holding, "holding");
    name_acceleration(model, acceleration);
    acceleration
}

/// What draws at the axis: sums of B, with moments `u x B`; world axes.
struct Pulls {
    any: Components,
    /// Of those that are perpendicular to u.
    across: Components,
}

fn pulls(model: &mut Model, axis: Axis) -> Pulls {
    let center = Point::Body(model.frames.graph.zeros());
    let loads: Vec<_> = model
        .loads
        .iter()
        .map(|load| (load.force, load.point, load.moment, load.pull))
        .collect();
    let mut list = Vec::new();
    for (force, point, moment, pull) in loads {
        if let (Point::Body(offset), Attitude::Line { direction, .. }) =
            (point, model.frames.attitude)
        {
            let along = model.frames.graph.dot(direction, offset);
            list.push(model.frames.graph.scale_vector(along, force.world));
        } else if !model.frames.is_zero_vector(force) {
            let arm = arm(model, point, center);
            let moment = model.frames.cross(arm, force);
            list.push(pull_of(model, axis, moment.world));
        }
        list.push(match pull {
            Some(pull) => pull,
            None => pull_of(model, axis, moment.world),
        });
    }
    let zeros = model.frames.graph.zeros();
    let mut pulls = Pulls {
        any: zeros,
        across: zeros,
    };
    for pull in list {
        let is_across = is_across_axis(model, axis, pull);
        if !is_across && is_along_axis(model, pull) {
            continue;
        }
        let sum = if is_across {
            &mut pulls.across
        } else {
            &mut pulls.any
        };
        *sum = model.frames.graph.add_vectors(*sum, pull);
    }
    pulls
}

/// B of a moment K: of a multiple of `u x b`, that of b; else `K x u`.
fn pull_of(model: &mut Model, axis: Axis, moment: Components) -> Components {
    let opposite = model.frames.graph.negate_vector(moment);
    let (one, minus_one) = (model.frames.graph.one(), model.frames.graph.integer(-1));
    for (sign, mut rest) in [(one, moment), (minus_one, opposite)] {
        let mut factor = sign;
        loop {
            let known = model.frames.swept.iter().find(|(swept, _)| *swept == rest);
            if let Some((_, pull)) = known {
                return model.frames.graph.scale_vector(factor, *pull);
            }
            let Some((common, without)) = model.frames.common_factor(rest) else {
                break;
            };
            factor = model.frames.graph.multiply(factor, common);
            rest = without;
        }
    }
    model.frames.graph.cross(moment, axis.unit)
}

/// Whether a vector is perpendicular to the axis in all states.
fn is_across_axis(model: &mut Model, axis: Axis, vector: Components) -> bool {
    let along = model.frames.graph.dot(axis.unit, vector);
    all_vanish(model, &[along])
}

/// Whether a vector is along the axis in all states: a force on the axis has no moment then.
pub fn is_along_axis(model: &mut Model, vector: Components) -> bool {
    let Some(Axis { unit, .. }) = model.state.axis else {
        return false;
    };
    let across = model.frames.graph.cross(unit, vector);
    all_vanish(model, &across)
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
            let along = model.frames.graph.dot(axis.unit, moment.world);
            (model.loads[index].extent, along)
        })
        .collect();
    let parts: Vec<Id> = moments.iter().map(|(_, along)| *along).collect();
    let together = model.frames.graph.sum(&parts);
    if all_vanish(model, &[together]) {
        return Some(());
    }
    for index in turning(model, &parts) {
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
    let wrong = turning(model, &parts);
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

/// Which of the moments along the axis do not vanish.
fn turning(model: &mut Model, parts: &[Id]) -> Vec<usize> {
    let samples = samples(model, parts);
    (0..parts.len())
        .filter(|index| !samples[*index].is_zero())
        .collect()
}
