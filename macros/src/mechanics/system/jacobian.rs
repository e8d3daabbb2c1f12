//! Jacobians of points: how their velocities depend on the rates of the joints.

use crate::model::{Frame, System, Workspace};
use crate::symbolic::{Components, Id};

use super::rates::rates;

/// For each rate of the system: the velocity of a point and the angular velocity of its body per
/// unit of that rate, in world axes.
pub type Jacobian = Vec<[Components; 2]>;

/// The Jacobians of the requested points, with the rates in the order of the state.
pub fn derive_jacobians(system: &System, work: &mut Workspace) -> Vec<Jacobian> {
    let by: Vec<Id> = rates(system);
    let points = system.points.iter().map(|(body, offset)| {
        let state = &system.bodies[*body].state;
        let swept = work.graph.cross(state.angular_velocity, *offset);
        let swept = work.vector(state.body, swept);
        let velocity = work.add(state.velocity, swept);
        let turning = work.vector(state.body, state.angular_velocity);
        let velocity = work.components(velocity, Frame::WORLD);
        let turning = work.components(turning, Frame::WORLD);
        let columns = by.iter().map(|rate| {
            [velocity, turning].map(|vector| {
                let column = work.graph.derivative(&vector, *rate);
                [column[0], column[1], column[2]].map(|entry| work.graph.result(entry))
            })
        });
        columns.collect()
    });
    points.collect()
}
