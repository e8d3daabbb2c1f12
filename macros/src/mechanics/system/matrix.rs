//! The mass matrix of a system, and its generalized forces.

use crate::mechanics::tree::MassMatrix;
use crate::model::{System, Workspace};
use crate::symbolic::Id;

use super::closed::moved_in_world;
use super::constraints::replace;
use super::equations::SystemEquations;
use super::rates::order;

/// `M q'' = f`, in the order of the rates in the state, without the loads of constraints outside
/// the tree.
pub struct Inertias {
    pub rows: Vec<Vec<Id>>,
    /// The drive of each coordinate, minus the load that the motion needs without acceleration.
    pub driving: Vec<Id>,
}

/// The mass matrix, and the generalized forces.
pub fn derive_inertias(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Inertias {
    let tree = moved_in_world(work, &equations.built.tree);
    let found = MassMatrix::derive(&mut work.graph, &mut work.labels, &tree);
    let driving = replace(&mut work.graph, &found.driving, equations.values());
    let order = order(system, &equations.built);
    let mut result = |id: Id| work.graph.result(id);
    Inertias {
        rows: order
            .iter()
            .map(|row| {
                order
                    .iter()
                    .map(|column| result(found.rows[*row][*column]))
                    .collect()
            })
            .collect(),
        driving: order.iter().map(|row| result(driving[*row])).collect(),
    }
}
