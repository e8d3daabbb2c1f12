//! The first-order change of the accelerations, from the change of the balances.
//!
//! ```text
//! r(x, a) = 0, linear in a:    M da = -dr,    M = dr/da
//! ```
//!
//! Here r is the load along each freedom that inverse dynamics finds, minus the load that acts
//! there. So the elimination that gives the accelerations is not differentiated, and M is factored
//! only once. For a body that is alone, the row is its acceleration minus its solution: `a - a(x)`.

use std::collections::HashMap;

use crate::mechanics::tree::MassMatrix;
use crate::mechanics::tree::link::Tree;
use crate::model::{System, TreeJoint, Workspace};
use crate::symbolic::Id;

use super::closed::moved_in_world;
use super::equations::SystemEquations;
use super::loads::lacking_with;
use super::rates::order;

/// The balances along the freedoms of a tree, with given accelerations.
pub struct Response {
    matrix: MassMatrix,
    /// The load that is lacking along each freedom, as a function of the symbols of the
    /// accelerations.
    pub lacking: Vec<Id>,
    /// The accelerations that these symbols stand for.
    values: HashMap<Id, Id>,
    /// The accelerations, solved for with the same matrix, in the order of the state.
    pub accelerations: Vec<Id>,
    /// The indices of the freedoms, in the order of the state.
    order: Vec<usize>,
}

impl Response {
    /// The response of a tree without constraints whose loads do not depend on accelerations.
    pub fn of(system: &System, work: &mut Workspace, equations: &SystemEquations) -> Option<Self> {
        equations.closed.is_none().then_some(())?;
        let tree = moved_in_world(work, &equations.reduced);
        let given: Vec<Vec<Id>> = system.joints.iter().map(TreeJoint::accelerations).collect();
        let mut lacking = lacking_with(work, equations, &tree, &given);
        let mut matrix = MassMatrix::derive(&mut work.graph, &mut work.labels, &tree);
        for (freedom, (symbol, found)) in solved_alone(equations, &tree, &given) {
            lacking[freedom] = work.graph.subtract(symbol, found);
            matrix.separate(&mut work.graph, freedom, found);
        }
        let found = matrix.solve(&mut work.graph, &mut work.labels);
        let order = order(system, &equations.built);
        let joints = system.joints.iter().zip(given);
        let open = joints.filter(|(joint, _)| !joint.is_driven());
        let symbols = open.flat_map(|(_, symbols)| symbols);
        Some(Self {
            matrix,
            lacking,
            accelerations: order.iter().map(|freedom| found[*freedom]).collect(),
            values: symbols.zip(found.iter().copied()).collect(),
            order,
        })
    }

    /// The change of the accelerations, in the order of the state, for this change of the lacking
    /// loads.
    pub fn to(&mut self, work: &mut Workspace, change: &[Id]) -> Vec<Id> {
        let known = &self.values;
        let change = work.graph.substitute(change, |id| known.get(&id).copied());
        self.matrix.driving = change.iter().map(|id| work.graph.negate(*id)).collect();
        let found = self.matrix.solve(&mut work.graph, &mut work.labels);
        self.order.iter().map(|freedom| found[*freedom]).collect()
    }
}

/// The freedoms of bodies that are alone, each with the symbol of its acceleration and the solution
/// for it.
fn solved_alone(
    equations: &SystemEquations,
    tree: &Tree,
    given: &[Vec<Id>],
) -> Vec<(usize, (Id, Id))> {
    let mut next = 0;
    let mut all = Vec::new();
    for (joint, links) in equations.built.links.iter().enumerate() {
        let count: usize = tree.links[links.clone()]
            .iter()
            .map(|link| link.open().count())
            .sum();
        if equations.alone[joint] {
            let solved = given[joint].iter().copied();
            let solved = solved.zip(equations.accelerations[joint].iter().copied());
            all.extend((next..next + count).zip(solved));
        }
        next += count;
    }
    all
}
