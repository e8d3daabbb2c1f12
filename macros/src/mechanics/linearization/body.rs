//! The linearization of a body: its accelerations are differentiated in each direction of its
//! states.

use std::collections::BTreeMap;

use crate::mechanics::variation::Direction;
use crate::model::{Attitude, Group, Meaning, Model, Outline, Pair, Variable, Workspace};
use crate::symbolic::Id;

use super::blocks::{Linearization, assemble};
use super::changes::{Column, Directions, changes, of_inputs};

/// The derivatives of the accelerations of a body.
pub fn linearize_body(
    outline: &Outline,
    model: &Model,
    work: &mut Workspace,
    pair: Pair,
) -> Linearization {
    let accelerations = in_order(model, pair);
    let mut directions = Directions::new();
    for (number, group) in outline.tangent().iter().enumerate() {
        let components = 0..group.size;
        let components = components.map(|component| direction(model, work, group, component));
        directions.push((Column::State(number), components.collect()));
    }
    directions.extend(of_inputs(outline, work));
    let as_they_are = |_: &mut Workspace, change: Vec<Id>| change;
    let changes = changes(
        work,
        &accelerations,
        &accelerations,
        &directions,
        as_they_are,
    );
    let spin = |_: &Workspace, _| model.state.angular_velocity;
    assemble(outline, work, accelerations, &changes, spin)
}

/// The accelerations of the state, and the rates of user-defined states.
pub fn in_order(model: &Model, Pair { linear, angular }: Pair) -> Vec<Id> {
    let motion = model.motion;
    let accelerations = [
        &linear[motion.linear_axes()],
        &angular[motion.angular_axes()],
    ];
    let rates = model.states.iter().map(|state| state.rate);
    accelerations.concat().into_iter().chain(rates).collect()
}

/// A component of the tangent space changes by one.
fn direction(model: &Model, work: &mut Workspace, group: &Group, component: usize) -> Direction {
    let (state, one) = (&model.state, work.graph.one());
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
        (Variable::AngularVelocity, Some((_, rate)), _) => Direction::of_symbol(work, Some(rate)),
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
