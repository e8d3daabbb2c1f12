//! Kinetic energy, and the energy of potentials and uniform fields.

use crate::families::Family;
use crate::model::Inertia;
use crate::model::Load;
use crate::model::Meaning;
use crate::model::Model;
use crate::model::Point;
use crate::model::Vector;
use crate::model::Workspace;
use crate::symbolic::{Components, Graph, Id, Node, Number};

use super::dyadic::quadratic;
use super::newton_euler::inertia_about_center;

/// The expressions of `outputs: [energy]`, in joules.
pub struct Energy {
    /// `(m v^2 + w . J w) / 2`
    pub kinetic: Id,
    /// All potentials, and `-F . x` of every uniform field, `x` where it acts.
    pub potential: Id,
}

pub fn derive_energy(model: &Model, work: &mut Workspace) -> Energy {
    Energy {
        kinetic: kinetic(model, work),
        potential: potential(model, work),
    }
}

/// Of a body with a support, `w . J_P w / 2` about the point that is held.
fn kinetic(model: &Model, work: &mut Workspace) -> Id {
    let twice = twice_kinetic(model, work);
    let graph = &mut work.graph;
    let half = graph.number(Number::ratio(1, 2));
    graph.distribute(half, twice)
}

/// `m v^2 + w . J w`
pub fn twice_kinetic(model: &Model, work: &mut Workspace) -> Id {
    let translation = match model.mass {
        Some(mass) if model.motion.translates() => {
            let square = work.norm_squared(model.state.velocity);
            work.graph.multiply(mass, square)
        }
        _ => work.graph.zero(),
    };
    let inertia = inertia_about_center(model, work);
    let w = model.state.angular_velocity;
    let rotation = match (&inertia, model.hinge(&mut work.graph)) {
        (Inertia::Absent, _) => work.graph.zero(),
        (Inertia::Scalar(moment), _) => {
            let graph = &mut work.graph;
            let square = graph.norm_squared(model.state.turning());
            graph.multiply(*moment, square)
        }
        (Inertia::Spatial(rows), _) => quadratic(&mut work.graph, rows, w),
    };
    work.graph.add(translation, rotation)
}

fn potential(model: &Model, work: &mut Workspace) -> Id {
    let graph = &mut work.graph;
    let potentials: Vec<Id> = model
        .loads
        .iter()
        .filter_map(|load| load.potential)
        .collect();
    let mut potential = graph.sum(&potentials);
    let fields: Vec<(Vector, Components)> = model
        .loads
        .iter()
        .filter_map(|load| Some((load.force, uniform_field(model, work, load)?)))
        .collect();
    for (force, offset) in fields {
        // where the motion of G is not modelled, positions count from G
        let position = model.state.place(work, Point::Body(offset));
        let done = work.dot(force, position);
        potential = work.graph.subtract(potential, done);
    }
    potential
}

/// The point of the body at which a uniform field acts: a field force that is fixed in world axes and
/// is the same for every position, attitude and velocity.
pub fn uniform_field(model: &Model, work: &Workspace, load: &Load) -> Option<Components> {
    let graph: &Graph = &work.graph;
    let of_state = |id: Id| match graph.node(id) {
        Node::Symbol(symbol) => !matches!(
            work.meanings.of(*symbol),
            Meaning::Time | Meaning::Param(..) | Meaning::Input(..)
        ),
        _ => false,
    };
    let Point::Body(offset) = load.point else {
        return None;
    };
    let force = load.force;
    let is_uniform = load.family == Family::Field
        && load.potential.is_none()
        && work.is_zero_vector(load.moment)
        && (graph.is_zero_vector(&force.body) || !model.motion.has_attitude())
        && !graph.depends_on(&[force.body, force.world].concat(), of_state);
    is_uniform.then_some(offset)
}
