//! The force balance (1.3) and the moment balance (1.4), solved for the accelerations.
//!
//! ```text
//! m a = sum of F                          world axes
//! J w' = sum of M_G - w x J w             body axes
//! ```

use crate::errors::Errors;
use crate::model::{Frame, Inertia, Load, Model, Point, Vector};
use crate::symbolic::{Components, Id};

use super::euler_equations::solve_euler;
use super::reactions::given_parts;
use super::rod;

/// Linear acceleration of G in world axes and angular acceleration in body axes, as far as the motion
/// has them; that of a hinge stands in the place of z, that of the axis of a rod in the place of all.
pub fn derive_accelerations(
    model: &mut Model,
    errors: &mut Errors,
) -> Option<(Components, Components)> {
    model
        .frames
        .labels
        .describe("linear", "(1.3), world axes: a = sum of F / m");
    if let Some(axis) = model.state.axis {
        rod::check_loads(model, axis, errors)?;
        let linear = linear_acceleration(model, "linear");
        return Some((linear, rod::axis_acceleration(model, axis)));
    }
    let center = model.state.center(&mut model.frames);
    let given = if model.motion.has_attitude() {
        given_parts(model, center)
    } else {
        // where moments are unknown, whether they can balance these is found with them
        if model.reactions.is_empty() {
            check_moment_free(model, errors)?;
        }
        Vec::new()
    };
    let labels = &mut model.frames.labels;
    if model.motion.is_planar() || model.motion.is_hinged() {
        labels.describe("angular", "(1.4): w' = M / J");
    }
    labels.describe("angular", "(1.4), body axes: w' = J^-1 (M - w x J w)");
    let given = given.into_iter().map(|(_, moment)| moment);
    Some(solve_balances(
        model,
        given.collect(),
        ["linear", "angular"],
    ))
}

/// The accelerations that the loads of the model and further moments make, under these names.
pub fn solve_balances(
    model: &mut Model,
    further: Vec<Vector>,
    names: [&str; 2],
) -> (Components, Components) {
    let linear = linear_acceleration(model, names[0]);
    let center = model.state.center(&mut model.frames);
    let mut moments = moments_about(model, center);
    let angular = if model.motion.has_attitude() {
        moments.extend(further);
        angular_acceleration(model, moments, names[1])
    } else {
        model.frames.graph.zeros()
    };
    (linear, angular)
}

/// (1.3): `a = F / m`. All that is fixed in the body is added before it is turned.
fn linear_acceleration(model: &mut Model, name: &str) -> Components {
    let (true, Some(mass)) = (model.motion.translates(), model.mass) else {
        return model.frames.graph.zeros();
    };
    let resultant = resultant(model);
    let one = model.frames.graph.one();
    let inverse_mass = model.frames.graph.divide(one, mass);
    model.frames.labels.name(inverse_mass, "inverse_mass");
    let mut specific = |force: Components| {
        force.map(|component| model.frames.graph.distribute(inverse_mass, component))
    };
    let specific = Vector {
        body: specific(resultant.body),
        world: specific(resultant.world),
    };
    model.frames.labels.describe(
        "specific_force",
        "what is fixed in the body: sum of F / m, body axes",
    );
    model.frames.labels.vector("specific_force", specific.body);
    let acceleration = model.frames.components(specific, Frame::World);
    let acceleration = model.frames.graph.results(acceleration);
    model.frames.labels.vector(name, acceleration);
    acceleration
}

/// The sum of all forces.
pub fn resultant(model: &mut Model) -> Vector {
    let forces: Vec<Vector> = model.loads.iter().map(|load| load.force).collect();
    model.frames.sum(forces)
}

/// The moment of each load about `pole`.
pub fn moments_about(model: &mut Model, pole: Point) -> Vec<Vector> {
    let loads: Vec<(Vector, Point, Vector)> = model
        .loads
        .iter()
        .map(|load| (load.force, load.point, load.moment))
        .collect();
    loads
        .into_iter()
        .map(|(force, point, moment)| {
            if model.frames.is_zero_vector(force) {
                return moment;
            }
            let arm = arm(model, point, pole);
            let turning = model.frames.cross(arm, force);
            model.frames.add(turning, moment)
        })
        .collect()
}

/// `P - O`, from the pole O to the point P.
pub fn arm(model: &mut Model, point: Point, pole: Point) -> Vector {
    let from_center = |model: &mut Model, point: Point| match point {
        Point::Body(offset) => Some(model.frames.fixed_in_body(offset)),
        Point::Moving(offset) => Some(offset),
        Point::World(_) => None,
    };
    if let (Some(end), Some(start)) = (from_center(model, point), from_center(model, pole)) {
        let backwards = model.frames.negate(start);
        return model.frames.add(end, backwards);
    }
    let end = model.state.place(&mut model.frames, point);
    let start = model.state.place(&mut model.frames, pole);
    let backwards = model.frames.negate(start);
    model.frames.add(end, backwards)
}

/// (1.4) about G, or about the point that is held, whose reaction has no moment there:
/// `w' = J^-1 (M - w x J w)`.
fn angular_acceleration(model: &mut Model, moments: Vec<Vector>, name: &str) -> Components {
    let moment = model.frames.sum(moments);
    let moment = model.frames.components(moment, Frame::Body);
    let angular = match (inertia_about_center(model), model.hinge()) {
        (Inertia::Absent, _) => model.frames.graph.zeros(),
        (inertia, Some(axis)) => about_axis(model, &inertia, axis, moment),
        (Inertia::Scalar(inertia), None) if model.state.axis.is_some() => {
            let graph = &mut model.frames.graph;
            let one = graph.one();
            let inverse = graph.divide(one, inertia);
            moment.map(|part| graph.distribute(inverse, part))
        }
        (Inertia::Scalar(inertia), None) => {
            let axis = [0, 0, 1].map(|component| model.frames.graph.integer(component));
            about_axis(model, &Inertia::Scalar(inertia), axis, moment)
        }
        (Inertia::Spatial(rows), None) => solve_euler(model, &rows, moment),
    };
    let angular = model.frames.graph.results(angular);
    let labels = &mut model.frames.labels;
    if model.motion.is_planar() || model.motion.is_hinged() {
        labels.name(angular[2], name);
    }
    labels.vector(name, angular);
    angular
}

/// About one axis d, `w x J w` has no part along it: `w' = d.M / d.J d`.
fn about_axis(
    model: &mut Model,
    inertia: &Inertia,
    d: Components,
    moment: Components,
) -> Components {
    let about_axis = moment_of_inertia(model, inertia, d);
    let graph = &mut model.frames.graph;
    let one = graph.one();
    let inverse = graph.divide(one, about_axis);
    let driving = graph.dot(d, moment);
    model.frames.labels.name(inverse, "inverse_inertia");
    let zero = graph.zero();
    [zero, zero, graph.distribute(inverse, driving)]
}

/// `d.J d`, of a unit vector d; in the plane, the moment of inertia.
pub fn moment_of_inertia(model: &mut Model, inertia: &Inertia, d: Components) -> Id {
    let graph = &mut model.frames.graph;
    match inertia {
        Inertia::Absent => graph.zero(),
        Inertia::Scalar(moment) => *moment,
        Inertia::Spatial(rows) => {
            let momentum = graph.transform(rows, d);
            graph.dot(d, momentum)
        }
    }
}

/// The inertia about G, or about the point that is held: `J_P = J_G + m (c^2 1 - c c)`, `c = G - P`.
pub fn inertia_about_center(model: &mut Model) -> Inertia {
    let (Some(support), Some(mass)) = (model.state.support, model.mass) else {
        return model.inertia;
    };
    let graph = &mut model.frames.graph;
    let inertia = model.inertia.displaced(graph, mass, support.offset);
    match inertia {
        Inertia::Scalar(moment) => model.frames.labels.name(moment, "inertia_about_support"),
        Inertia::Spatial(rows) => model.frames.labels.matrix("inertia_about_support", &rows),
        Inertia::Absent => {}
    }
    inertia
}

/// A body that does not turn needs a moment balance of its own: nothing else could hold it.
pub fn check_moment_free(model: &mut Model, errors: &mut Errors) -> Option<()> {
    let center = model.state.center(&mut model.frames);
    let moments = moments_about(model, center);
    let total = model.frames.sum(moments.iter().copied());
    if model.frames.is_zero_vector(total) {
        return Some(());
    }
    let unbalanced: Vec<&Load> = model
        .loads
        .iter()
        .zip(&moments)
        .filter(|(_, moment)| !model.frames.is_zero_vector(**moment))
        .map(|(load, _)| load)
        .collect();
    for load in unbalanced {
        let motion = model.motion.word();
        errors.push(load.extent, format!("`{}` has a moment about G that nothing balances, and under `motion: {motion}` the body does not turn: let it act at G, balance it by a reaction, or let the body turn", load.name));
    }
    None
}
