//! The linearization of a body: its accelerations are differentiated in each direction of its
//! tangent space.

use std::collections::BTreeMap;

use crate::mechanics::variation::Direction;
use crate::model::{Attitude, Group, Meaning, Model, Pair, Variable, Workspace};
use crate::symbolic::Components;

use super::differentiated::{Differentiated, Tangent};

/// The expressions that are differentiated for a body.
pub fn differentiated_body(model: &Model, Pair { linear, angular }: Pair) -> Differentiated {
    let motion = model.motion;
    let accelerations = [
        &linear[motion.linear_axes()],
        &angular[motion.angular_axes()],
    ];
    Differentiated::directly(accelerations.concat(), &model.states)
}

impl Tangent for Model {
    fn direction(&self, work: &mut Workspace, group: &Group, component: usize) -> Direction {
        let (state, one) = (&self.state, work.graph.one());
        match (group.variable, state.angle, work.attitude(state.body)) {
            (Variable::Quaternion, ..) => {
                let e = work.graph.unit_vectors()[component];
                let e = work.vector(state.body, e);
                Direction::turn(work, state.body, e)
            }
            (Variable::Angle, Some((angle, _)), Attitude::Axis { direction, .. }) => Direction {
                changes: BTreeMap::from([(angle, one)]),
                turns: BTreeMap::from([(state.body, work.vector(state.body, direction))]),
            },
            (Variable::AngularVelocity, Some((_, rate)), _) => {
                Direction::of_symbol(work, Some(rate))
            }
            (Variable::Own, ..) => {
                let own = work.symbol_of(Meaning::Own(group.first));
                Direction::of_symbol(work, own)
            }
            (variable, ..) => {
                let meaning = Meaning::Of(state.body, variable, component);
                Direction::of_symbol(work, work.symbol_of(meaning))
            }
        }
    }

    fn spin(&self, _: &Workspace, _: usize) -> Components {
        self.state.angular_velocity
    }
}
