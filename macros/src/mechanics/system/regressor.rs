//! The regressor of a system: the loads along each freedom that its motion requires, per inertial
//! parameter of each body.

use crate::mechanics::answers::{Regressor, told};
use crate::mechanics::tree::{self, Properties};
use crate::model::{PLANAR, SPATIAL, System, TreeJoint, Workspace};

use super::closed::moved_in_world;
use super::equations::SystemEquations;
use super::loads::by_link;
use super::rates::order;

/// The regressor of each body, about the point that its joint holds. Carriers come first.
pub fn derive_system_regressors(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Vec<Regressor> {
    let tree = moved_in_world(work, &equations.built.tree);
    let given: Vec<Vec<_>> = system.joints.iter().map(TreeJoint::accelerations).collect();
    let by_link = by_link(equations, &tree, &given);
    let motions = tree::motions((&mut work.graph, &mut work.labels), &tree, &by_link);
    let order = order(system, &equations.built);
    let units = Properties::units(&work.graph);
    let is_told = told(if system.is_planar { &PLANAR } else { &SPATIAL });
    let bodies = (0..system.bodies.len()).map(|body| {
        let link = equations.built.body(body);
        let columns = is_told.iter().map(|number| {
            let taken = motions[link].taken_by(&mut work.graph, &units[*number]);
            let along = tree::along_freedoms(&mut work.graph, &tree, link, taken);
            let rows = order.iter();
            rows.map(|row| work.graph.result(along[*row])).collect()
        });
        let columns = columns.collect();
        let entries = tree.links[link].properties.entries();
        let parameters = is_told.iter();
        let parameters = parameters.map(|number| work.graph.result(entries[*number]));
        Regressor {
            columns,
            parameters: parameters.collect(),
        }
    });
    bodies.collect()
}
