//! Kinetic energy, and the energy of potentials and uniform fields.

use crate::mechanics::balances::{twice_kinetic, uniform_field};
use crate::model::{Load, Model, Point, State, Workspace};
use crate::symbolic::{Id, Number};

/// The expressions of `outputs: [energy]`, in joules.
pub struct Energy {
    /// `(m v^2 + w . J w) / 2`
    pub kinetic: Id,
    /// All potentials, and `-F . x` for every uniform field, where `x` is its point of action.
    pub potential: Id,
}

pub fn derive_energy(model: &Model, work: &mut Workspace) -> Energy {
    Energy {
        kinetic: kinetic(model, work),
        potential: potential(model, work),
    }
}

/// The kinetic energy; for a body with a support, `w . J_P w / 2` about the held point.
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
    for load in &model.loads {
        if let Some(done) = done_by_field(work, &model.state, load) {
            potential = work.graph.subtract(potential, done);
        }
    }
    potential
}

/// `F . x` for a uniform field, where `x` is its point of action. If the motion of G is not
/// modeled, positions are relative to G.
pub fn done_by_field(work: &mut Workspace, state: &State, load: &Load) -> Option<Id> {
    let offset = uniform_field(work, state.body, load)?;
    let position = state.place(work, Point::Fixed(state.body, offset));
    Some(work.dot(load.force, position))
}
