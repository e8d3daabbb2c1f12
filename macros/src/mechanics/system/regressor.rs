//! The regressor of a system: the loads along each freedom that its motion requires, per inertial
//! parameter of each body.

use crate::mechanics::answers::{Regressor, falls, told};
use crate::mechanics::tree::{self, Properties};
use crate::model::{PLANAR, SPATIAL, System, TreeJoint, Workspace};
use crate::symbolic::Components;

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
    let mut tree = moved_in_world(work, &equations.built.tree);
    let falls = falls(work, system.unweighed.as_ref());
    tree.gravity = most_common(work, system, &falls);
    let given: Vec<Vec<_>> = system.joints.iter().map(TreeJoint::accelerations).collect();
    let by_link = by_link(equations, &tree, &given);
    let mut motions = tree::motions((&mut work.graph, &mut work.labels), &tree, &by_link);
    for (body, fall) in falls.iter().enumerate() {
        if work.graph.is_zero(system.bodies[body].mass) {
            continue;
        }
        let link = equations.built.body(body);
        let graph = &mut work.graph;
        let more = graph.subtract_vectors(*fall, tree.gravity);
        let more = tree::from_world(graph, &tree.links, link, more);
        let linear = &mut motions[link].acceleration.linear;
        *linear = graph.subtract_vectors(*linear, more);
        *linear = graph.quantities(*linear);
    }
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

/// The acceleration of free fall of most bodies with mass, if it is constant.
fn most_common(work: &Workspace, system: &System, falls: &[Components]) -> Components {
    let graph = &work.graph;
    let bodies = system.bodies.iter().zip(falls);
    let massive = bodies.filter(|(body, _)| !graph.is_zero(body.mass));
    let massive: Vec<Components> = massive.map(|(_, fall)| *fall).collect();
    let constant = massive.iter().filter(|fall| graph.are_early(*fall));
    let count = |fall: &&Components| massive.iter().filter(|other| other == fall).count();
    constant.max_by_key(count).copied().unwrap_or(graph.zeros())
}
