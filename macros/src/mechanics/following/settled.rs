//! Loads of a body that depend on the acceleration that they cause, such as added mass, or a load
//! that depends on the rate of an angle of attack. They are linear in the acceleration,
//!
//! ```text
//! m a = F_0 + A a + B w'          a in body axes, where these turn freely
//! w' = J^-1 (M(a, w') - w x J w)
//! ```
//!
//! and these terms are moved to the left side and solved for.

use crate::errors::Errors;
use crate::mechanics::balances::{
    inertia_about_center, is_diagonal, known_parts, moments_about, resultant,
};
use crate::mechanics::proofs::samples;
use crate::model::{Frame, Inertia, Load, Meaning, Model, Pair, Variable, Vector, Workspace};
use crate::symbolic::{Components, Equation, Graph, Id, Size};

/// An acceleration on which loads depend, and the residual of its balance, which is zero.
struct Followed {
    variable: Variable,
    axis: usize,
    symbol: Id,
    residual: Id,
}

/// The accelerations, and the symbols of those on which loads depend, each with its value.
pub struct Settled {
    pub values: Vec<(Id, Id)>,
    pub accelerations: Pair,
}

impl Settled {
    /// A vector with the symbols replaced by their values.
    pub fn put_into(&self, graph: &mut Graph, vector: Components) -> Components {
        if self.values.is_empty() {
            return vector;
        }
        graph.replaced(vector, &self.values)
    }
}

/// Solves for the accelerations on which loads depend. The given accelerations are functions of
/// their symbols.
pub fn settle(
    model: &Model,
    work: &mut Workspace,
    accelerations: Pair,
    errors: &mut Errors,
) -> Option<Settled> {
    let followed = list_followed(model, work, accelerations);
    if followed.is_empty() {
        return Some(Settled {
            values: Vec::new(),
            accelerations,
        });
    }
    let symbols: Vec<Id> = followed.iter().map(|one| one.symbol).collect();
    let residuals: Vec<Id> = followed.iter().map(|one| one.residual).collect();
    let equations = equations(work, &residuals, &symbols);
    let solved = work.graph.solve(equations, symbols.len());
    if !solved.undetermined.is_empty() {
        let mut loads = model.loads.iter().filter(|load| load.follows(work));
        let (place, name) = loads.next().map(|load| (load.mention, &load.name))?;
        let place = place.unwrap_or(name.span().into());
        return errors.report(place, takes_inertia(&name.to_string()));
    }
    let values: Vec<(Id, Id)> = symbols.into_iter().zip(solved.values).collect();
    for (_, reciprocal) in &solved.pivots {
        work.labels
            .divide_for(*reciprocal, "acceleration".to_owned());
    }
    let accelerations = put_into(model, work, &followed, &values, accelerations);
    Some(Settled {
        values,
        accelerations,
    })
}

/// The message for a load that cancels all inertia.
pub fn takes_inertia(name: &str) -> String {
    format!("`{name}` cancels the inertia: nothing determines the acceleration")
}

/// All components of the linear or the angular acceleration if loads depend on any component of it.
fn list_followed(model: &Model, work: &mut Workspace, accelerations: Pair) -> Vec<Followed> {
    let loads = model.loads.iter();
    let parts: Vec<Id> = loads
        .flat_map(|load| work.entries(&[load.force, load.moment]))
        .collect();
    let symbols = work.accelerations_in(&parts);
    let of = |work: &Workspace, id: Id| match work.meaning(id) {
        Some(Meaning::Of(_, variable, _)) => Some(variable),
        _ => None,
    };
    let mut followed = Vec::new();
    for variable in [
        Variable::AccelerationInBody,
        Variable::LinearAcceleration,
        Variable::AngularAcceleration,
        Variable::AxisAcceleration,
    ] {
        if symbols.iter().any(|id| of(work, *id) == Some(variable)) {
            let residual = residual(model, work, variable, accelerations);
            for (axis, residual) in residual.into_iter().enumerate() {
                let meaning = Meaning::Of(model.state.body, variable, axis);
                followed.extend(work.symbol_of(meaning).map(|symbol| Followed {
                    variable,
                    axis,
                    symbol,
                    residual,
                }));
            }
        }
    }
    followed
}

/// The residuals of the balance of an acceleration, along its axes; they vanish.
fn residual(
    model: &Model,
    work: &mut Workspace,
    variable: Variable,
    Pair { linear, angular }: Pair,
) -> Components {
    let (body, zero) = (model.state.body, work.graph.zero());
    let symbols = [0, 1, 2].map(|axis| {
        let known = work.symbol_of(Meaning::Of(body, variable, axis));
        known.unwrap_or(zero)
    });
    match (variable, model.moved_mass()) {
        (Variable::AccelerationInBody, Some(mass)) => {
            let force = resultant(work, &model.loads);
            let force = work.components(force, body);
            let graph = &mut work.graph;
            let taken = graph.scale_vector(mass, symbols);
            graph.subtract_vectors(taken, force)
        }
        (Variable::LinearAcceleration, _) => work.graph.subtract_vectors(symbols, linear),
        (Variable::AngularAcceleration, _) => moments_lacking(model, work, symbols)
            .unwrap_or_else(|| work.graph.subtract_vectors(symbols, angular)),
        _ => work.graph.subtract_vectors(symbols, angular),
    }
}

/// `J w' + w x J w - M` for a full tensor, so that the tensor need not be inverted separately.
fn moments_lacking(model: &Model, work: &mut Workspace, rate: Components) -> Option<Components> {
    let Inertia::Spatial(rows) = inertia_about_center(model, work) else {
        return None;
    };
    let is_held = model.motion.is_hinged() || !model.constraints.is_empty();
    if is_held || is_diagonal(&work.graph, &rows) {
        return None;
    }
    let center = model.state.center(work);
    let mut moments = moments_about(&model.state, work, &model.loads, center);
    let known = known_parts(model, work, center).into_iter();
    moments.extend(known.map(|(_, moment)| moment));
    let moment = work.sum(moments);
    let moment = work.components(moment, model.state.axes);
    // a multiple of the unit matrix does not change w x J w
    let (graph, w) = (&mut work.graph, model.state.angular_velocity);
    let mut deviator = rows;
    for (axis, row) in deviator.iter_mut().enumerate() {
        row[axis] = graph.difference(row[axis], rows[2][2]);
    }
    let relative = graph.transform(&deviator, w);
    let relative = graph.quantities(relative);
    let gyroscopic = graph.cross(w, relative);
    let driven = graph.transform(&rows, rate);
    let taken = graph.add_vectors(driven, gyroscopic);
    Some(graph.subtract_vectors(taken, moment))
}

/// The equations in these unknowns that the residuals are.
fn equations(work: &mut Workspace, residuals: &[Id], symbols: &[Id]) -> Vec<Equation> {
    let graph = &mut work.graph;
    let zero = graph.zero();
    let rest = graph.substitute(residuals, |id| symbols.contains(&id).then_some(zero));
    let slopes: Vec<Vec<Id>> = symbols
        .iter()
        .map(|symbol| graph.derivative(residuals, *symbol))
        .collect();
    let rows: Vec<Vec<Id>> = (0..residuals.len())
        .map(|row| slopes.iter().map(|slopes| slopes[row]).collect())
        .collect();
    let mut values = samples(work, &rows.concat()).into_iter();
    let equations = rows.into_iter().zip(rest).enumerate();
    let equations = equations.map(|(row, (coefficients, rest))| {
        // the inertia is on the diagonal, so the terms beside it are smaller
        let mut sizes = vec![Size::Beside; coefficients.len()];
        sizes[row] = Size::Terms;
        Equation {
            sample: values.by_ref().take(coefficients.len()).collect(),
            sizes,
            active: None,
            right: work.graph.negate(rest),
            coefficients,
        }
    });
    equations.collect()
}

/// The accelerations: those solved for, and the others with these put in.
fn put_into(
    model: &Model,
    work: &mut Workspace,
    followed: &[Followed],
    values: &[(Id, Id)],
    Pair { linear, angular }: Pair,
) -> Pair {
    let solved = |variable: Variable| {
        let mut components = work.graph.zeros();
        let all = followed.iter().zip(values);
        let own = all.filter(|(one, _)| one.variable == variable);
        let mut is_there = false;
        for (one, (_, value)) in own {
            components[one.axis] = *value;
            is_there = true;
        }
        is_there.then_some(components)
    };
    let in_body = solved(Variable::AccelerationInBody);
    let in_world = solved(Variable::LinearAcceleration);
    let turning = [Variable::AngularAcceleration, Variable::AxisAcceleration];
    let turning = turning.into_iter().find_map(solved);
    let linear = match (in_body, in_world) {
        (Some(in_body), _) => {
            work.labels.describe(
                "acceleration",
                "of G, body axes: with the loads that follow it",
            );
            work.labels.vector("acceleration", in_body);
            work.turn(in_body, model.state.body, Frame::WORLD)
        }
        (None, Some(in_world)) => in_world,
        (None, None) => work.graph.replaced(linear, values),
    };
    let angular = turning.unwrap_or_else(|| work.graph.replaced(angular, values));
    let (linear, angular) = (work.graph.results(linear), work.graph.results(angular));
    work.labels.vector("linear", linear);
    if model.motion.has_angle() {
        work.labels.name(angular[2], "angular");
    }
    work.labels.vector("angular", angular);
    Pair { linear, angular }
}

/// The body with the solutions put into its loads. Loads as functions of the symbols are kept
/// beside them.
pub fn with_settled(model: Model, work: &mut Workspace, settled: &Settled) -> Model {
    if settled.values.is_empty() {
        return model;
    }
    Model {
        loads: loads_with(&model.loads, work, &settled.values),
        following: model.loads,
        ..model
    }
}

/// The body with loads that use given accelerations.
pub fn as_given(model: &Model, work: &mut Workspace) -> Option<Model> {
    if model.following.is_empty() {
        return None;
    }
    let body = model.state.body;
    let given = work.components(model.state.acceleration, body);
    let mut values = Vec::new();
    for (axis, given) in given.into_iter().enumerate() {
        let symbol = work.symbol_of(Meaning::Of(body, Variable::AccelerationInBody, axis));
        values.extend(symbol.map(|symbol| (symbol, given)));
    }
    Some(Model {
        loads: loads_with(&model.following, work, &values),
        following: Vec::new(),
        ..model.clone()
    })
}

/// Loads with symbols replaced by values.
fn loads_with(loads: &[Load], work: &mut Workspace, values: &[(Id, Id)]) -> Vec<Load> {
    let mut put = |vector: Vector| work.map(vector, |graph, part| graph.replaced(part, values));
    let loads = loads.iter();
    loads
        .map(|load| load.with(put(load.force), put(load.moment)))
        .collect()
}
