//! The force balance (1.3) and the moment balance (1.4), solved for the accelerations.
//!
//! ```text
//! m a = sum of F                          world axes
//! J w' = sum of M_G - w x J w             body axes
//! ```

use crate::errors::Errors;
use crate::model::{Frame, Inertia, Load, Model, Pair, Vector, Workspace};
use crate::symbolic::Components;

use super::euler_equations::{EulerForm, solve_euler};
use super::loads::{check_moment_free, known_parts, moments_about, resultant};
use super::moments::{inertia_about_center, moment_of_inertia};
use super::rod;

/// The accelerations that the motion has. For a rod, the acceleration of its axis takes the place
/// of the angular one.
pub fn derive_accelerations(
    model: &Model,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<(Pair, Option<EulerForm>)> {
    work.labels
        .describe("linear", "(1.3), world axes: a = sum of F / m");
    if let Some(axis) = model.state.axis {
        rod::check_loads(model, work, &model.loads, axis, errors)?;
        let linear = linear_acceleration(model, work, &model.loads, Some("linear"));
        let angular = rod::axis_acceleration(model, work, axis);
        return Some((Pair { linear, angular }, None));
    }
    let center = model.state.center(work);
    let known = if model.motion.has_attitude() {
        known_parts(model, work, center)
    } else {
        // unknown moments may balance the others: this is checked when they are solved for
        if model.reactions.is_empty() {
            check_moment_free(model, work, &model.loads, errors)?;
        }
        Vec::new()
    };
    let labels = &mut work.labels;
    if model.motion.has_angle() {
        labels.describe("angular", "(1.4): w' = M / J");
    }
    labels.describe("angular", "(1.4), body axes: w' = J^-1 (M - w x J w)");
    let known = known.into_iter().map(|(_, moment)| moment);
    Some(solve_balances(
        model,
        work,
        &model.loads,
        known.collect(),
        Some(["linear", "angular"]),
    ))
}

/// The accelerations under loads and further moments. They get these names, if there are any.
pub fn solve_balances(
    model: &Model,
    work: &mut Workspace,
    loads: &[Load],
    further: Vec<Vector>,
    names: Option<[&str; 2]>,
) -> (Pair, Option<EulerForm>) {
    let linear = linear_acceleration(model, work, loads, names.map(|[linear, _]| linear));
    let center = model.state.center(work);
    let mut moments = moments_about(&model.state, work, loads, center);
    let (angular, form) = if model.motion.has_attitude() {
        moments.extend(further);
        angular_acceleration(model, work, moments, names.map(|[_, angular]| angular))
    } else {
        (work.graph.zeros(), None)
    };
    (Pair { linear, angular }, form)
}

/// (1.3): `a = F / m`. All forces fixed in the body are added before they are rotated.
fn linear_acceleration(
    model: &Model,
    work: &mut Workspace,
    loads: &[Load],
    name: Option<&str>,
) -> Components {
    let Some(mass) = model.moved_mass() else {
        return work.graph.zeros();
    };
    let resultant = resultant(work, loads);
    let inverse_mass = work.graph.inverse_of_positive(mass);
    work.labels.name(inverse_mass, "inverse_mass");
    let specific = work.map(resultant, |graph, force| {
        force.map(|component| graph.distribute(inverse_mass, component))
    });
    work.labels.describe(
        "specific_force",
        "what is fixed in the body: sum of F / m, body axes",
    );
    let in_body = work.part(specific, model.state.body);
    work.labels.vector("specific_force", in_body);
    let acceleration = work.components(specific, Frame::WORLD);
    let acceleration = work.graph.results(acceleration);
    if let Some(name) = name {
        work.labels.vector(name, acceleration);
    }
    acceleration
}

/// (1.4) about G, or about the held point, where the reaction of the support has no moment:
/// `w' = J^-1 (M - w x J w)`.
fn angular_acceleration(
    model: &Model,
    work: &mut Workspace,
    moments: Vec<Vector>,
    name: Option<&str>,
) -> (Components, Option<EulerForm>) {
    let moment = work.sum(moments);
    let moment = work.components(moment, model.state.axes);
    let mut form = None;
    let angular = match (
        inertia_about_center(model, work),
        model.hinge(&mut work.graph),
    ) {
        (Inertia::Absent, _) => work.graph.zeros(),
        (inertia, Some(axis)) => about_axis(work, &inertia, axis, moment),
        (Inertia::Scalar(inertia), None) if model.state.axis.is_some() => {
            let graph = &mut work.graph;
            let inverse = graph.inverse_of_positive(inertia);
            moment.map(|part| graph.distribute(inverse, part))
        }
        (Inertia::Scalar(inertia), None) => {
            let axis = [0, 0, 1].map(|component| work.graph.integer(component));
            about_axis(work, &Inertia::Scalar(inertia), axis, moment)
        }
        (Inertia::Spatial(rows), None) => {
            let (angular, written) = solve_euler(model, work, &rows, moment);
            form = Some(written);
            angular
        }
    };
    let angular = work.graph.results(angular);
    if let Some(name) = name {
        if model.motion.has_angle() {
            work.labels.name(angular[2], name);
        }
        work.labels.vector(name, angular);
    }
    (angular, form)
}

/// About an axis d: `w' = d.M / d.J d`, because `w x J w` has no part along d.
fn about_axis(
    work: &mut Workspace,
    inertia: &Inertia,
    d: Components,
    moment: Components,
) -> Components {
    let about_axis = moment_of_inertia(work, inertia, d);
    let graph = &mut work.graph;
    let inverse = graph.inverse_of_positive(about_axis);
    let driving = graph.dot(d, moment);
    work.labels.name(inverse, "inverse_inertia");
    let zero = graph.zero();
    [zero, zero, graph.distribute(inverse, driving)]
}
