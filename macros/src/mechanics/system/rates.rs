//! The rates of a system, in the order of its state.

use crate::model::{System, TreeJoint, Variable};
use crate::symbolic::Id;

/// Those of all joints that move.
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
