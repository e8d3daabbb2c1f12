//! The terms of the balances, for inspection: given loads, resultants, residuals.

use crate::families::Family;
use crate::mechanics::balances::{about_pole, arm, moments_about, resultant};
use crate::mechanics::following::as_given;
use crate::model::{Frame, Inertia, Load, Model, Point, State, Vector, Workspace};
use crate::symbolic::{Components, Id};

/// The expressions of `outputs: [balance]` of one body, in world axes.
pub struct Balance {
    /// The given loads, and in systems the weight; the moment is about G.
    pub applied: Resultant,
    /// The residuals of (1.3) and (1.4), which are zero on an actual motion. Moments are about the
    /// pole; in systems they are about G, and the loads of all joints are included.
    pub residual: Resultant,
    pub loads: Vec<LoadExpressions>,
}

/// A resultant force and moment, in world axes.
pub struct Resultant {
    pub force: Components,
    pub moment: Components,
}

impl Balance {
    pub fn roots(&self) -> Vec<Id> {
        let wrenches = [&self.applied, &self.residual].into_iter();
        let resultants = wrenches.flat_map(|wrench| [wrench.force, wrench.moment]);
        let loads = self.loads.iter();
        let loads = loads.flat_map(|load| [load.force, load.point, load.moment]);
        resultants.chain(loads).flatten().collect()
    }

    /// Substitutes solutions into the given loads that depend on them.
    pub fn put_solved(&mut self, work: &mut Workspace, values: &[(Id, Id)]) {
        let own = [&mut self.applied.force, &mut self.applied.moment];
        let listed = self.loads.iter_mut();
        let listed = listed.flat_map(|load| [&mut load.force, &mut load.point, &mut load.moment]);
        for components in own.into_iter().chain(listed) {
            *components = work.graph.replaced(*components, values);
        }
    }
}

/// One load, in world axes.
pub struct LoadExpressions {
    pub name: String,
    pub family: Family,
    pub force: Components,
    /// The point of action; measured from G if the motion of G is not modeled.
    pub point: Components,
    pub moment: Components,
}

impl LoadExpressions {
    /// The expressions of a load at this point, with this moment.
    pub fn new(
        state: &State,
        work: &mut Workspace,
        load: &Load,
        (point, moment): (Point, Vector),
    ) -> Self {
        let place = state.place(work, point);
        Self {
            name: load.name.to_string(),
            family: load.family,
            force: work.components(load.force, Frame::WORLD),
            point: work.components(place, Frame::WORLD),
            moment: work.components(moment, Frame::WORLD),
        }
    }
}

/// Under constraints, loads may depend on reactions, whose values are `solved`.
pub fn derive_balance(model: &Model, work: &mut Workspace, solved: &[Components]) -> Balance {
    let force = resultant(work, &model.loads);
    let center = model.state.mass_center(work);
    let moments = moments_about(&model.state, work, &model.loads, center);
    let moment = work.sum(moments);
    let applied = in_world(work, force, moment);

    // a load that depends on an acceleration uses the one that is given
    let given = as_given(model, work);
    let (force, moment) = match &given {
        Some(given) => {
            let moments = moments_about(&given.state, work, &given.loads, center);
            (resultant(work, &given.loads), work.sum(moments))
        }
        None => (force, moment),
    };
    let (force, moment) = with_reactions(model, work, force, moment);
    // (1.3): sum of F - m a = 0
    let inertial_force = inertial_force(model, work);
    let force = work.add(force, inertial_force);
    // (1.4): sum of M_G + M_iG + (G - O) x (sum of F - m a) = 0
    let inertial_moment = inertial_moment(model, work);
    let about_center = work.add(moment, inertial_moment);
    let from_pole = from_pole(model, work);
    let transport = work.cross(from_pole, force);
    let about_pole = work.add(about_center, transport);
    let residual = in_world(work, force, about_pole);

    let loads = list_loads(model, work);
    let mut balance = Balance {
        applied,
        residual,
        loads,
    };
    if !model.constraints.is_empty() {
        let reactions = model.reactions.iter();
        let symbols = reactions.map(|reaction| work.part(reaction.symbols, Frame::WORLD));
        let values = symbols.zip(solved);
        let values = values.flat_map(|(symbols, value)| symbols.into_iter().zip(*value));
        let values: Vec<(Id, Id)> = values.collect();
        balance.put_solved(work, &values);
    }
    balance
}

fn in_world(work: &mut Workspace, force: Vector, moment: Vector) -> Resultant {
    let force = work.components(force, Frame::WORLD);
    let moment = work.components(moment, Frame::WORLD);
    work.labels
        .describe("force", "sum of the forces, world axes");
    work.labels
        .describe("moment", "sum of the moments, world axes");
    let (force, moment) = (work.graph.results(force), work.graph.results(moment));
    work.labels.vector("force", force);
    work.labels.vector("moment", moment);
    Resultant { force, moment }
}

/// The sum of the given loads and the given reactions; the moment is about G.
fn with_reactions(
    model: &Model,
    work: &mut Workspace,
    force: Vector,
    moment: Vector,
) -> (Vector, Vector) {
    let center = model.state.mass_center(work);
    let (mut forces, mut moments) = (vec![force], vec![moment]);
    for reaction in &model.reactions {
        let (force, moment) = about_pole(&model.state, work, reaction, reaction.symbols, center);
        forces.push(force);
        moments.push(moment);
    }
    (work.sum(forces), work.sum(moments))
}

/// `G - O`, for the pole O.
pub fn from_pole(model: &Model, work: &mut Workspace) -> Vector {
    let (center, pole) = (model.state.mass_center(work), model.pole);
    arm(&model.state, work, center, pole)
}

/// (1.8): `F_iG = -m a`.
fn inertial_force(model: &Model, work: &mut Workspace) -> Vector {
    let Some(mass) = model.mass else {
        return Vector::ZERO;
    };
    let acceleration = model.state.acceleration;
    let rate = work.scale(mass, acceleration);
    work.negate(rate)
}

/// (1.9), completed: `M_i = -(J w' + w x J w)`.
fn inertial_moment(model: &Model, work: &mut Workspace) -> Vector {
    let (w, rate) = (
        model.state.angular_velocity,
        model.state.angular_acceleration,
    );
    let graph = &mut work.graph;
    let mut gyroscopic = graph.zeros();
    if let Inertia::Spatial(rows) = model.inertia {
        let momentum = graph.transform(&rows, w);
        let momentum = graph.quantities(momentum);
        work.labels.describe("momentum", "J w, body axes");
        work.labels.vector("momentum", momentum);
        gyroscopic = graph.cross(w, momentum);
    }
    let driven = model.inertia.times(graph, rate);
    let change = graph.add_vectors(driven, gyroscopic);
    let moment = graph.negate_vector(change);
    work.vector(model.state.axes, moment)
}

/// The given loads, one by one. Loads that act all over the body are listed at G.
fn list_loads(model: &Model, work: &mut Workspace) -> Vec<LoadExpressions> {
    let center = model.state.mass_center(work);
    let about_center = moments_about(&model.state, work, &model.loads, center);
    let loads = model.loads.iter().zip(about_center);
    let list = loads.map(|(load, about_center)| {
        let at = if load.potential.is_some() {
            (center, about_center)
        } else {
            (load.point, load.moment)
        };
        LoadExpressions::new(&model.state, work, load, at)
    });
    list.collect()
}
