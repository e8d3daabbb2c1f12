//! The balances as they are written, for inspection: given loads, resultants, residuals.

use crate::model::{Family, Frame, Inertia, Model, Point, Vector};
use crate::symbolic::Components;

use super::newton_euler::{arm_from_center, moments_about_center, resultant};

/// The expressions of `outputs: [balance]`, in world axes.
pub struct Balance {
    /// Given loads; moment about G.
    pub applied: Resultant,
    /// (1.3) and (1.4) about the pole: zero on a true motion.
    pub residual: Resultant,
    pub loads: Vec<LoadExpressions>,
}

/// A resultant force and moment, world axes.
pub struct Resultant {
    pub force: Components,
    pub moment: Components,
}

/// One load, world axes.
pub struct LoadExpressions {
    pub name: String,
    pub family: Family,
    pub force: Components,
    /// Where it acts; from G where the motion of G is not modelled.
    pub point: Components,
    pub moment: Components,
}

pub fn derive_balance(model: &mut Model) -> Balance {
    let force = resultant(model);
    let moments = moments_about_center(model);
    let moment = model.frames.sum(moments);
    let applied = in_world(model, force, moment);

    // (1.3): sum of F - m a = 0
    let inertial_force = inertial_force(model);
    let force = model.frames.add(force, inertial_force);
    // (1.4): sum of M_G + M_iG + (G - O) x (sum of F - m a) = 0
    let inertial_moment = inertial_moment(model);
    let about_center = model.frames.add(moment, inertial_moment);
    let from_pole = from_pole(model);
    let transport = model.frames.cross(from_pole, force);
    let about_pole = model.frames.add(about_center, transport);
    let residual = in_world(model, force, about_pole);

    let loads = list_loads(model);
    Balance {
        applied,
        residual,
        loads,
    }
}

fn in_world(model: &mut Model, force: Vector, moment: Vector) -> Resultant {
    let force = model.frames.components(force, Frame::World);
    let moment = model.frames.components(moment, Frame::World);
    model
        .frames
        .labels
        .describe("force", "sum of the forces, world axes");
    model
        .frames
        .labels
        .describe("moment", "sum of the moments, world axes");
    let (force, moment) = (
        model.frames.graph.results(force),
        model.frames.graph.results(moment),
    );
    model.frames.labels.vector("force", force);
    model.frames.labels.vector("moment", moment);
    Resultant { force, moment }
}

/// `G - O`, of the pole O.
pub fn from_pole(model: &mut Model) -> Vector {
    let pole = model.pole;
    let arm = arm_from_center(model, pole);
    model.frames.negate(arm)
}

/// (1.8): `F_iG = -m a`.
fn inertial_force(model: &mut Model) -> Vector {
    let Some(mass) = model.mass else {
        return model.frames.zero_vector();
    };
    let momentum_rate = model
        .frames
        .vector(Frame::World, model.state.linear_acceleration);
    let rate = model.frames.scale(mass, momentum_rate);
    model.frames.negate(rate)
}

/// (1.9), completed: `M_i = -(J w' + w x J w)`.
fn inertial_moment(model: &mut Model) -> Vector {
    let (w, rate) = (
        model.state.angular_velocity,
        model.state.angular_acceleration,
    );
    let graph = &mut model.frames.graph;
    let change = match model.inertia {
        Inertia::Absent => graph.zeros(),
        Inertia::Planar(inertia) => graph.scale_vector(inertia, rate),
        Inertia::Spatial(rows) => {
            let momentum = graph.transform(&rows, w);
            let momentum = graph.quantities(momentum);
            model.frames.labels.describe("momentum", "J w, body axes");
            model.frames.labels.vector("momentum", momentum);
            let gyroscopic = graph.cross(w, momentum);
            let driven = graph.transform(&rows, rate);
            graph.add_vectors(driven, gyroscopic)
        }
    };
    let moment = graph.negate_vector(change);
    model.frames.vector(Frame::Body, moment)
}

fn list_loads(model: &mut Model) -> Vec<LoadExpressions> {
    use crate::model::LoadKind;
    let loads: Vec<_> = model
        .loads
        .iter()
        .map(|load| {
            (
                load.name.to_string(),
                load.family,
                load.kind,
                load.vector,
                load.point,
            )
        })
        .collect();
    let list = loads
        .into_iter()
        .map(|(name, family, kind, vector, point)| {
            let zeros = model.frames.graph.zeros();
            let vector = model.frames.components(vector, Frame::World);
            let (force, moment) = if kind == LoadKind::Force {
                (vector, zeros)
            } else {
                (zeros, vector)
            };
            let point = position(model, point);
            LoadExpressions {
                name,
                family,
                force,
                point,
                moment,
            }
        });
    list.collect()
}

fn position(model: &mut Model, point: Point) -> Components {
    match point {
        Point::World(position) => position,
        Point::Body(offset) => {
            let position = Vector {
                body: offset,
                world: model.state.position,
            };
            model.frames.components(position, Frame::World)
        }
    }
}
