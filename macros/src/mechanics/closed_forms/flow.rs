//! Motions in closed form: the one that a body has, or what prevents it.
//!
//! G moves on a parabola if all forces on the body are constant in world axes. The rotation is one
//! of
//!
//! ```text
//! in space        freely: no moment about G, or about the point that is held
//!                 as Lagrange's top: a couple k x e, of a body that is symmetric about e
//!                 spinning up: a constant moment N e, of such a body
//! about an axis   with constant acceleration, or as a pendulum: w' = a sin theta + b cos theta
//! as a rod        freely, along a great circle
//! ```

use crate::errors::{Errors, Extent};
use crate::mechanics::balances::{known_parts, moments_about};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Inertia, Model, Orientation, Pair, Vector, Workspace};
use crate::symbolic::Components;

use super::about_axis::about_axis;
use super::axial_torque::axial_torque;
use super::axis_of_symmetry::axes_of_symmetry;
use super::forms::{Contribution, Flow, Rotation, dependence};
use super::free_rotation::free;
use super::lagrange_top::lagrange_top;
use super::solid::Solid;

/// The closed form. All obstacles are reported where it is requested.
pub fn derive_flow(
    model: &Model,
    work: &mut Workspace,
    place: Extent,
    accelerations: Pair,
    errors: &mut Errors,
) -> Option<Flow> {
    if !model.constraints.is_empty() {
        return errors.report(
            place,
            "under constraints there is no closed form in this version: use a motion with a support, or leave out \
             `flow`, and the motion is integrated",
        );
    }
    let known = [model.inertia_entries(), model.mass.into_iter().collect()].concat();
    if !work.graph.are_early(&known) {
        return errors.report(
            place,
            "no closed form: mass and inertia change; leave out `flow`, and the motion is integrated",
        );
    }
    let contributions = contributions(model, work);
    let mut obstacles = Vec::new();
    if !work.graph.are_early(&accelerations.linear) {
        obstacles.extend(unsteady_forces(work, &contributions));
    }
    let rotation = rotation(
        model,
        work,
        &accelerations.angular,
        &contributions,
        &mut obstacles,
    );
    obstacles.dedup();
    for obstacle in &obstacles {
        errors.push(
            place,
            format!("no closed form: {obstacle}; leave out `flow`, and the motion is integrated"),
        );
    }
    let rotation = rotation.filter(|_| obstacles.is_empty())?;
    Some(Flow {
        linear: accelerations.linear,
        rotation,
    })
}

fn contributions(model: &Model, work: &mut Workspace) -> Vec<Contribution> {
    let center = model.state.center(work);
    let moments = moments_about(&model.state, work, &model.loads, center);
    let forces = model.loads.iter().map(|load| load.force);
    let mut parts: Vec<(Vector, Vector)> = forces.zip(moments).collect();
    if model.motion.has_attitude() {
        parts.extend(known_parts(model, work, center));
    }
    let loads = model.loads.iter().map(|load| &load.name);
    let names = loads.chain(model.reactions.iter().map(|reaction| &reaction.name));
    let all = names
        .zip(parts)
        .map(|(name, (force, moment))| Contribution {
            name: name.to_string(),
            force: work.components(force, Frame::WORLD),
            moment: work.components(moment, model.state.axes),
        });
    all.collect()
}

/// The forces that are not constant in world axes.
fn unsteady_forces(work: &Workspace, contributions: &[Contribution]) -> Vec<String> {
    let unsteady = contributions
        .iter()
        .filter(|load| !work.graph.are_early(&load.force));
    unsteady
        .map(|load| {
            let reason = dependence(work, &load.force);
            format!(
                "the force `{}` depends on {reason}, and is not constant in world axes",
                load.name
            )
        })
        .collect()
}

pub fn rotation(
    model: &Model,
    work: &mut Workspace,
    angular: &Components,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) -> Option<Rotation> {
    match model.motion.orientation {
        Orientation::Fixed => return Some(Rotation::None),
        Orientation::Angle => {
            return about_axis(model, work, angular[2], contributions, obstacles);
        }
        Orientation::Quaternion | Orientation::Line => {}
    }
    let moments: Vec<Components> = contributions.iter().map(|load| load.moment).collect();
    let zeros = work.graph.zeros();
    let total = moments
        .into_iter()
        .fold(zeros, |sum, moment| work.graph.add_vectors(sum, moment));
    let is_free = all_vanish(work, &total);
    if model.motion.is_line() {
        if is_free {
            return Some(Rotation::GreatCircle);
        }
    } else if is_free {
        let solid = Solid::of(model, work)?;
        return Some(Rotation::Free(free(&solid, work)));
    } else if let Some(rotation) = symmetric_body(model, work, total) {
        return Some(rotation);
    }
    report_moments(model, work, contributions, obstacles);
    None
}

fn symmetric_body(model: &Model, work: &mut Workspace, moment: Components) -> Option<Rotation> {
    symmetric(&Solid::of(model, work)?, work, moment)
}

/// The rotation of a symmetric body under a moment.
pub fn symmetric(solid: &Solid, work: &mut Workspace, moment: Components) -> Option<Rotation> {
    if let Some(top) = lagrange_top(solid, work, moment) {
        return Some(Rotation::Top(top));
    }
    axial_torque(solid, work, moment).map(Rotation::Axial)
}

/// Reports the moments that prevent a free rotation, unless they make a top or a spin that is
/// linear in time.
fn report_moments(
    model: &Model,
    work: &mut Workspace,
    contributions: &[Contribution],
    obstacles: &mut Vec<String>,
) {
    let center = if model.motion.is_supported() {
        "the point that is held"
    } else {
        "G"
    };
    let is_rod = model.motion.is_line();
    let solid = Solid::of(model, work);
    let is_symmetric = solid.is_some_and(|solid| !axes_of_symmetry(&solid, work, &[]).is_empty());
    let (mut harmless, before) = (Vec::new(), obstacles.len());
    for load in contributions {
        if all_vanish(work, &load.moment) {
            continue;
        }
        if !is_rod && symmetric_body(model, work, load.moment).is_some() {
            harmless.push(format!("`{}`", load.name));
            continue;
        }
        let is_constant = work.graph.are_early(&load.moment);
        let manner = if is_constant {
            "is constant in the body".to_owned()
        } else {
            format!("depends on {}", dependence(work, &load.moment))
        };
        let reason = match (is_symmetric, is_constant) {
            _ if is_rod => "and a rod has a closed form only without moments",
            (false, _) if is_known(model, work) => {
                "and the body is not symmetric about an axis through it"
            }
            (false, _) => {
                "and the body is not known to be symmetric: equal moments are written alike, `principal(a, a, c)`"
            }
            (true, true) => {
                "but not known to be along an axis of symmetry (of a ball, an axis of the body or a direction in numbers)"
            }
            (true, false) => "and is not that of constant forces on the axis of symmetry",
        };
        let name = &load.name;
        obstacles.push(format!(
            "the moment of `{name}` about {center} {manner}, {reason}"
        ));
    }
    if obstacles.len() == before {
        let names = harmless.join(" and ");
        obstacles.push(format!(
            "each of the moments of {names} alone has a closed form, but all together have none"
        ));
    }
}

/// Whether all moments of inertia are numbers.
fn is_known(model: &Model, work: &Workspace) -> bool {
    match &model.inertia {
        Inertia::Spatial(rows) => work.graph.constant_matrix(rows).is_some(),
        _ => true,
    }
}
