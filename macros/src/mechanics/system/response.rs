//! The first-order change of the accelerations, from the change of the balances.
//!
//! ```text
//! r(x, a) = 0, linear in a:    M da = -dr,    M = dr/da
//! ```
//!
//! Here r is the load along each freedom that inverse dynamics finds, minus the load that acts
//! there. So the elimination that gives the accelerations is not differentiated, and M is factored
//! only once. It is the mass matrix, minus the slopes of loads that depend on accelerations. For a
//! body that is alone, the row is its acceleration minus its solution: `a - a(x)`.

use std::collections::HashMap;

use crate::mechanics::tree::MassMatrix;
use crate::mechanics::tree::link::Tree;
use crate::model::{System, TreeJoint, Workspace};
use crate::symbolic::{Equation, Id};

use super::closed::{Following, equations, moved_in_world};
use super::equations::SystemEquations;
use super::loads::lacking_with;
use super::rates::order;

/// The balances along the freedoms of a tree, with given accelerations.
pub struct Response {
    slopes: Slopes,
    /// The generalized force missing along each freedom, as a function of the symbols of the
    /// accelerations.
    pub lacking: Vec<Id>,
    /// The accelerations that these symbols stand for.
    values: HashMap<Id, Id>,
    /// The accelerations, solved for with the same matrix, in the order of the state.
    pub accelerations: Vec<Id>,
    /// The indices of the freedoms, in the order of the state.
    order: Vec<usize>,
}

/// The slopes of the balances by the accelerations.
enum Slopes {
    Masses(MassMatrix),
    /// With loads that depend on accelerations. The matrix need not be symmetric.
    Following(Vec<Equation>),
}

impl Slopes {
    /// The accelerations that take up these loads.
    fn solve(&mut self, work: &mut Workspace, loads: Vec<Id>) -> Vec<Id> {
        match self {
            Self::Masses(matrix) => {
                matrix.driving = loads;
                matrix.solve(&mut work.graph, &mut work.labels)
            }
            Self::Following(equations) => {
                let count = loads.len();
                for (equation, load) in equations.iter_mut().zip(loads) {
                    equation.right = load;
                }
                work.graph.solve(equations.clone(), count).values
            }
        }
    }
}

impl Response {
    /// The response of a tree without constraints.
    pub fn of(system: &System, work: &mut Workspace, found: &SystemEquations) -> Option<Self> {
        system.is_tree().then_some(())?;
        let tree = moved_in_world(work, &found.reduced);
        let given: Vec<Vec<Id>> = system.joints.iter().map(TreeJoint::accelerations).collect();
        let mut lacking = lacking_with(work, found, &tree, &given);
        let resisting = found.resisting(work, &tree);
        let mut matrix = MassMatrix::derive(&mut work.graph, &mut work.labels, &resisting);
        for (freedom, (symbol, solution)) in solved_alone(found, &tree, &given) {
            lacking[freedom] = work.graph.subtract(symbol, solution);
            matrix.separate(&mut work.graph, freedom, solution);
        }
        let open = system.joints.iter().zip(given);
        let open = open.filter(|(joint, _)| !joint.is_driven());
        let symbols: Vec<Id> = open.flat_map(|(_, symbols)| symbols).collect();
        let (mut slopes, driving) = if found.closed.is_some() {
            let following = Following {
                loads: &[],
                accelerations: &symbols,
            };
            let equations = equations(work, &matrix, &[], following);
            let driving = equations.iter().map(|equation| equation.right).collect();
            (Slopes::Following(equations), driving)
        } else {
            let driving = matrix.driving.clone();
            (Slopes::Masses(matrix), driving)
        };
        let solution = slopes.solve(work, driving);
        let order = order(system, &found.built);
        Some(Self {
            slopes,
            lacking,
            accelerations: order.iter().map(|freedom| solution[*freedom]).collect(),
            values: symbols.into_iter().zip(solution).collect(),
            order,
        })
    }

    /// The change of the accelerations, in the order of the state, for this change of the lacking
    /// loads.
    pub fn to(&mut self, work: &mut Workspace, change: &[Id]) -> Vec<Id> {
        let known = &self.values;
        let change = work.graph.substitute(change, |id| known.get(&id).copied());
        let loads = change.iter().map(|id| work.graph.negate(*id)).collect();
        let found = self.slopes.solve(work, loads);
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
