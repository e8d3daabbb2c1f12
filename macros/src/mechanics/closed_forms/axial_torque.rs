//! A constant moment N e along the axis of symmetry of a body.

use crate::mechanics::proofs::all_vanish;
use crate::model::Workspace;
use crate::symbolic::{Components, Id};

use super::axis_of_symmetry::axes_of_symmetry;
use super::solid::Solid;

/// What determines the motion of a symmetric body under a moment along its axis.
pub struct AxialTorque {
    /// The moments of inertia across the axis and about it.
    pub moments: [Id; 2],
    /// The unit vector e, in body axes.
    pub axis: Components,
    /// The torque N.
    pub torque: Id,
}

impl AxialTorque {
    pub fn roots(&self) -> Vec<Id> {
        [&self.moments[..], &self.axis[..], &[self.torque]].concat()
    }
}

/// The axis and the torque along it, if the moment in body axes is constant and along an axis of
/// symmetry.
pub fn axial_torque(
    solid: &Solid,
    work: &mut Workspace,
    moment: Components,
) -> Option<AxialTorque> {
    if !work.graph.are_early(&moment) {
        return None;
    }
    axes_of_symmetry(solid, work, &[moment])
        .into_iter()
        .find_map(|(moments, axis)| {
            let graph = &mut work.graph;
            let torque = graph.dot(moment, axis);
            let along = graph.scale_vector(torque, axis);
            let across = [0, 1, 2].map(|i| graph.subtract(moment[i], along[i]));
            let is_axial = all_vanish(work, &across);
            is_axial.then_some(AxialTorque {
                moments,
                axis,
                torque,
            })
        })
}
