//! What the given loads and the inertia leave in the balances.

use crate::mechanics::balances::{inertia_about_center, known_parts, moments_about, resultant};
use crate::model::{Frame, Load, Meaning, Model, Pair, Variable, Vector, Workspace};
use crate::symbolic::{Components, Id};

/// `-m a` and `-(J_C w' + w x J_C w)`, in the motion with these accelerations.
pub fn inertial(model: &Model, work: &mut Workspace, accelerations: Pair) -> (Vector, Vector) {
    let rate = spatial(model, work, accelerations.angular);
    let symbols = acceleration_symbols(model, work).into_iter();
    let symbols = symbols.map(|(id, variable, axis)| match variable {
        Variable::LinearAcceleration => (id, accelerations.linear[axis]),
        _ => (id, accelerations.angular[axis]),
    });
    let symbols: Vec<(Id, Id)> = symbols.collect();
    let acceleration = model.state.acceleration;
    let acceleration = work.map(acceleration, |graph, part| graph.replaced(part, &symbols));
    let w = model.state.angular_velocity;
    let inertia = inertia_about_center(model, work);
    let change = inertia.change(&mut work.graph, w, rate);
    resistance(model, work, acceleration, change)
}

/// An angular acceleration with all its components, also for a hinge, which has only one.
fn spatial(model: &Model, work: &mut Workspace, angular: Components) -> Components {
    let graph = &mut work.graph;
    match model.hinge(graph) {
        Some(d) => graph.scale_vector(angular[2], d),
        None => angular,
    }
}

/// `-m a`, and the negative of the rate of the angular momentum.
fn resistance(
    model: &Model,
    work: &mut Workspace,
    acceleration: Vector,
    change: Components,
) -> (Vector, Vector) {
    let change = work.graph.negate_vector(change);
    let force = model.mass.map_or(Vector::ZERO, |mass| {
        let rate = work.scale(mass, acceleration);
        work.negate(rate)
    });
    (force, work.vector(model.state.axes, change))
}

/// The symbols of the accelerations, each with its variable and the index of its component.
pub fn acceleration_symbols(model: &Model, work: &Workspace) -> Vec<(Id, Variable, usize)> {
    let state = &model.state;
    let mut roots = work.entries(&[state.acceleration]);
    roots.extend(state.angular_acceleration);
    let known = work.graph.nodes_of(&roots).into_iter();
    let symbols = known.filter_map(|id| match work.meaning(id)? {
        Meaning::Of(
            _,
            variable @ (Variable::LinearAcceleration | Variable::AngularAcceleration),
            axis,
        ) => Some((id, variable, axis)),
        _ => None,
    });
    symbols.collect()
}

/// The change of these due to the acceleration that one unit of an unknown causes.
pub fn inertial_change(
    model: &Model,
    work: &mut Workspace,
    Pair { linear, angular }: Pair,
) -> (Vector, Vector) {
    let rate = spatial(model, work, angular);
    let inertia = inertia_about_center(model, work);
    let graph = &mut work.graph;
    let swept = match model.state.support {
        Some(support) => graph.cross(support.offset, rate),
        None => graph.zeros(),
    };
    let change = inertia.times(graph, rate);
    let swept = work.vector(model.state.body, swept);
    let linear = work.vector(Frame::WORLD, linear);
    let acceleration = work.add(swept, linear);
    resistance(model, work, acceleration, change)
}

/// The sum of the given forces and that of their moments about the center, each with the inertial
/// part.
pub fn balances_without_unknowns(
    model: &Model,
    work: &mut Workspace,
    accelerations: Pair,
) -> (Vector, Vector) {
    let center = model.state.center(work);
    let known = known_parts(model, work, center);
    balances_of(model, work, &model.loads, known, accelerations)
}

/// The same for these loads, and for further forces with their moments.
pub fn balances_of(
    model: &Model,
    work: &mut Workspace,
    loads: &[Load],
    further: Vec<(Vector, Vector)>,
    accelerations: Pair,
) -> (Vector, Vector) {
    let center = model.state.center(work);
    let mut force = resultant(work, loads);
    let moments = moments_about(&model.state, work, loads, center);
    let mut moment = work.sum(moments);
    for (known_force, known_moment) in further {
        force = work.add(force, known_force);
        moment = work.add(moment, known_moment);
    }
    let (inertial_force, inertial_moment) = inertial(model, work, accelerations);
    let force = work.add(force, inertial_force);
    let moment = work.add(moment, inertial_moment);
    (force, moment)
}
