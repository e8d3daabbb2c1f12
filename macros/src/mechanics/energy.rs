//! Kinetic energy, and the potential energy of uniform fields.

use crate::model::{Family, Inertia, Load, LoadKind, Meaning, Model, Point, Vector};
use crate::symbolic::{Components, Graph, Id, Node, Number};

/// The expressions of `outputs: [energy]`, in joules.
pub struct Energy {
    /// `(m v^2 + w . J w) / 2`
    pub kinetic: Id,
    /// `-F . x` of every uniform field, `x` where it acts.
    pub potential: Id,
}

pub fn derive_energy(model: &mut Model) -> Energy {
    Energy {
        kinetic: kinetic(model),
        potential: potential(model),
    }
}

fn kinetic(model: &mut Model) -> Id {
    let w = model.state.angular_velocity;
    let graph = &mut model.frames.graph;
    let translation = match model.mass {
        Some(mass) => {
            let square = graph.norm_squared(model.state.velocity);
            graph.multiply(mass, square)
        }
        None => graph.zero(),
    };
    let rotation = match model.inertia {
        Inertia::Absent => graph.zero(),
        Inertia::Planar(inertia) => {
            let square = graph.square(w[2]);
            graph.multiply(inertia, square)
        }
        Inertia::Spatial(rows) => {
            let momentum = graph.transform(&rows, w);
            graph.dot(w, momentum)
        }
    };
    let twice = graph.add(translation, rotation);
    let half = graph.number(Number::ratio(1, 2));
    graph.distribute(half, twice)
}

fn potential(model: &mut Model) -> Id {
    let mut potential = model.frames.graph.zero();
    let fields: Vec<(Vector, Components)> = model
        .loads
        .iter()
        .filter_map(|load| Some((load.vector, uniform_field(model, load)?)))
        .collect();
    for (force, offset) in fields {
        // where G does not move, or its motion is not modelled, positions count from G
        let position = Vector {
            body: offset,
            world: model.state.position,
        };
        let work = model.frames.dot(force, position);
        potential = model.frames.graph.subtract(potential, work);
    }
    potential
}

/// The point of the body at which a uniform field acts: a field force that is written in world axes
/// and is the same for every position, attitude and velocity.
pub fn uniform_field(model: &Model, load: &Load) -> Option<Components> {
    let graph: &Graph = &model.frames.graph;
    let of_state = |id: Id| match graph.node(id) {
        Node::Symbol(symbol) => !matches!(
            model.meanings.of(*symbol),
            Meaning::Time | Meaning::Param(..) | Meaning::Input(..)
        ),
        _ => false,
    };
    let Point::Body(offset) = load.point else {
        return None;
    };
    let force = load.vector;
    let is_uniform = load.family == Family::Field
        && load.kind == LoadKind::Force
        && graph.is_zero_vector(&force.body)
        && !graph.depends_on(&force.world, of_state);
    is_uniform.then_some(offset)
}
