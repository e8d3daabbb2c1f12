//! The rates of a system, in the order of its state.

use crate::mechanics::tree::Built;
use crate::model::{System, TreeJoint, Variable};
use crate::symbolic::Id;

/// The rates of all moving joints.
pub fn rates(system: &System) -> Vec<Id> {
    let joints = system.written.iter();
    joints
        .flat_map(|joint| velocities(&system.joints[*joint]))
        .collect()
}

/// The rates in the state of a joint.
pub fn velocities(joint: &TreeJoint) -> Vec<Id> {
    let fields = joint.kind.shape.into_iter().flat_map(|shape| shape.fields);
    let fields = fields.filter(|field| {
        matches!(
            field.variable,
            Variable::Velocity | Variable::AngularVelocity
        )
    });
    let parts = fields
        .flat_map(|field| (0..field.names.len()).map(|part| (field.variable, field.first + part)));
    parts
        .filter_map(|(variable, part)| joint.coordinates.get(variable, part))
        .collect()
}

/// The indices of the open freedoms, which are counted link by link, in the order of their rates in
/// the state.
pub fn order(system: &System, built: &Built) -> Vec<usize> {
    let firsts = built.tree.links.iter().scan(0, |next, link| {
        let first = *next;
        *next += link.open().count();
        Some(first..*next)
    });
    let firsts: Vec<_> = firsts.collect();
    let written = system.written.iter();
    let links = written.flat_map(|joint| built.links[*joint].clone());
    links.flat_map(|link| firsts[link].clone()).collect()
}
