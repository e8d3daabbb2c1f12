//! Kinetic energy, and the potential energy of uniform fields.

use crate::model::{Family, Frame, Inertia, LoadKind, Meaning, Model, Point, Vector};
use crate::symbolic::{Graph, Id, Node, Number};

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
    if !model.motion.has_position() {
        return potential;
    }
    let fields: Vec<(Vector, Point)> = uniform_fields(model)
        .map(|load| (load.vector, load.point))
        .collect();
    for (force, point) in fields {
        let position = match point {
            Point::Body(offset) => Vector {
                body: offset,
                world: model.state.position,
            },
            Point::World(position) => model.frames.vector(Frame::World, position),
        };
        let work = model.frames.dot(force, position);
        potential = model.frames.graph.subtract(potential, work);
    }
    potential
}

/// Field forces that are the same everywhere in space: written in world axes, and independent of
/// position, attitude and velocity.
fn uniform_fields(model: &Model) -> impl Iterator<Item = &crate::model::Load> {
    model.loads.iter().filter(|load| {
        load.family == Family::Field
            && load.kind == LoadKind::Force
            && is_uniform(model, load.vector)
    })
}

pub fn is_uniform(model: &Model, force: Vector) -> bool {
    let graph: &Graph = &model.frames.graph;
    let of_state = |id: Id| match graph.node(id) {
        Node::Symbol(symbol) => !matches!(
            model.meanings.of(*symbol),
            Meaning::Time | Meaning::Param(..) | Meaning::Input(..)
        ),
        _ => false,
    };
    graph.is_zero_vector(&force.body) && !graph.depends_on(&force.world, of_state)
}
