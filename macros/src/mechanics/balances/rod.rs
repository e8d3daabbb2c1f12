//! (1.4) for a rod: since it has no inertia about its axis u, its rotation is that of u.
//!
//! ```text
//! u'' = (K x u) / J - u'^2 u
//! ```
//!
//! All vectors are in world axes, and K is perpendicular to u. If `K = u x B`, then
//! `K x u = B - (u . B) u`. This is so for forces, with the first moment `B = sum of s F`, for
//! potentials, and for most couples that can be written. These B are summed, and one projection is
//! enough. It is not needed if B is already perpendicular to the axis, as for damping.
//!
//! ```text
//! u'' = B / J - (u . B / J + u'^2) u
//! ```

use crate::errors::Errors;
use crate::mechanics::proofs::{all_vanish, samples};
use crate::model::{Attitude, Axis, Frame, Inertia, Load, Model, Vector, Workspace};
use crate::symbolic::{Components, Id};

use super::loads::{arm, moments_about};

/// u'' under the loads of the model, in world axes.
pub fn axis_acceleration(model: &Model, work: &mut Workspace, axis: Axis) -> Components {
    let Inertia::Scalar(inertia) = model.inertia else {
        return work.graph.zeros();
    };
    let Pulls { any, across } = pulls(model, work, axis);
    let Axis { unit, rate } = axis;
    let graph = &mut work.graph;
    let inverse = graph.inverse_of_positive(inertia);
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
    let labels = &mut work.labels;
    labels.name(inverse, "inverse_inertia");
    labels.describe("driving", "B / J, world axes: of forces, B = sum of s F");
    labels.vector("driving", driving);
    labels.describe("holding", "u.B / J + u'^2: it keeps the length of u");
    labels.name(holding, "holding");
    name_acceleration(work, acceleration);
    acceleration
}

/// Pulls at the axis: sums of B, whose moments are `u x B`, in world axes.
struct Pulls {
    any: Components,
    /// The sum of those B that are perpendicular to u.
    across: Components,
}

fn pulls(model: &Model, work: &mut Workspace, axis: Axis) -> Pulls {
    let center = model.state.mass_center(work);
    let mut list = Vec::new();
    for load in &model.loads {
        let attitude = work.attitude(model.state.body);
        let offset = load.point.offset(model.state.body);
        if let (Some(offset), Attitude::Line { direction, .. }) = (offset, attitude) {
            let along = work.graph.dot(direction, offset);
            let force = work.part(load.force, Frame::WORLD);
            list.push(work.graph.scale_vector(along, force));
        } else if !load.force.is_zero() {
            let arm = arm(&model.state, work, load.point, center);
            let moment = work.cross(arm, load.force);
            list.push(pull_of(work, axis, moment));
        }
        list.push(match load.pull {
            Some(pull) => pull,
            None => pull_of(work, axis, load.moment),
        });
    }
    let zeros = work.graph.zeros();
    let mut pulls = Pulls {
        any: zeros,
        across: zeros,
    };
    for pull in list {
        let is_across = is_across_axis(work, axis, pull);
        if !is_across && is_along_axis(model, work, pull) {
            continue;
        }
        let sum = if is_across {
            &mut pulls.across
        } else {
            &mut pulls.any
        };
        *sum = work.graph.add_vectors(*sum, pull);
    }
    pulls
}

/// B of a moment K. If K is a multiple of `u x b`, it is that multiple of b; otherwise it is
/// `K x u`.
fn pull_of(work: &mut Workspace, axis: Axis, moment: Vector) -> Components {
    let moment = work.part(moment, Frame::WORLD);
    let opposite = work.graph.negate_vector(moment);
    let (one, minus_one) = (work.graph.one(), work.graph.integer(-1));
    for (sign, mut rest) in [(one, moment), (minus_one, opposite)] {
        let mut factor = sign;
        loop {
            let known = work.swept.iter().find(|(swept, _)| *swept == rest);
            if let Some((_, pull)) = known {
                return work.graph.scale_vector(factor, *pull);
            }
            let Some((common, without)) = work.common_factor(rest, Frame::WORLD) else {
                break;
            };
            factor = work.graph.multiply(factor, common);
            rest = without;
        }
    }
    work.graph.cross(moment, axis.unit)
}

/// Whether a vector is perpendicular to the axis in all states.
fn is_across_axis(work: &mut Workspace, axis: Axis, vector: Components) -> bool {
    let along = work.graph.dot(axis.unit, vector);
    all_vanish(work, &[along])
}

/// Whether a vector is along the axis in all states, so that a force along it on the axis has no
/// moment.
pub fn is_along_axis(model: &Model, work: &mut Workspace, vector: Components) -> bool {
    let Some(Axis { unit, .. }) = model.state.axis else {
        return false;
    };
    let across = work.graph.cross(unit, vector);
    all_vanish(work, &across)
}

/// `u'' = w' x u - u'^2 u`
pub fn of_angular(work: &mut Workspace, axis: Axis, angular: Components) -> Components {
    let change = turned_by(work, axis, angular);
    let graph = &mut work.graph;
    let square = graph.norm_squared(axis.rate);
    let held = graph.scale_vector(square, axis.unit);
    let acceleration = graph.subtract_vectors(change, held);
    let acceleration = graph.results(acceleration);
    name_acceleration(work, acceleration);
    acceleration
}

/// The change of u under a rotation: `phi x u`.
pub fn turned_by(work: &mut Workspace, axis: Axis, turn: Components) -> Components {
    work.graph.cross(turn, axis.unit)
}

fn name_acceleration(work: &mut Workspace, acceleration: Components) {
    let labels = &mut work.labels;
    labels.describe("axis", "(1.4), world axes: u'' = (K x u) / J - u'^2 u");
    labels.vector("axis", acceleration);
}

/// Reports moments about the axis, unless they add up to zero: nothing can balance them.
pub fn check_loads(
    model: &Model,
    work: &mut Workspace,
    loads: &[Load],
    axis: Axis,
    errors: &mut Errors,
) -> Option<()> {
    let center = model.state.mass_center(work);
    let moments = moments_about(&model.state, work, loads, center);
    let parts = parts_along(work, axis, moments);
    let together = work.graph.sum(&parts);
    if all_vanish(work, &[together]) {
        return Some(());
    }
    for index in not_vanishing(work, &parts) {
        let Load { name, extent, .. } = &loads[index];
        errors.push(
            *extent,
            format!(
                "`{name}` has a moment about the axis, about which a rod has no inertia: let it act on \
                 the axis, or take its part perpendicular to the axis, as in `axis.cross(k).cross(axis)`"
            ),
        );
    }
    None
}

/// The parts of moments along the axis.
pub fn parts_along(
    work: &mut Workspace,
    axis: Axis,
    moments: impl IntoIterator<Item = Vector>,
) -> Vec<Id> {
    let parts = moments.into_iter().map(|moment| {
        let moment = work.part(moment, Frame::WORLD);
        work.graph.dot(axis.unit, moment)
    });
    parts.collect()
}

/// The indices of the parts that are not proved to vanish.
pub fn not_vanishing(work: &mut Workspace, parts: &[Id]) -> Vec<usize> {
    let samples = samples(work, parts);
    (0..parts.len())
        .filter(|index| !samples[*index].is_zero())
        .collect()
}
