//! Kinetic energy, and the energy of potentials and uniform fields.

use crate::mechanics::balances::{twice_kinetic, uniform_field};
use crate::model::{Model, Point, Vector, Workspace};
use crate::symbolic::{Components, Id, Number};

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

pub fn potential(model: &Model, work: &mut Workspace) -> Id {
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
        let position = model
            .state
            .place(work, Point::Fixed(model.state.body, offset));
        let done = work.dot(force, position);
        potential = work.graph.subtract(potential, done);
    }
    potential
}
