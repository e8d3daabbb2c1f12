//! The changes of expressions in one direction, by the forward chain rule: from the leaves to the
//! roots.
//!
//! A rotated vector changes as a vector does, whatever the form of its rotation. As the body
//! rotates by phi,
//!
//! ```text
//! (R v)' = R (v' + phi x v)        (R^T v)' = R^T v' - phi x R^T v        phi in body axes
//! ```

use std::collections::HashMap;

use crate::model::{Attitude, Turn, Workspace};
use crate::symbolic::{Components, Id};

use super::direction::Direction;
use super::leaves::Leaves;

/// The changes of `roots`, whose leaves these are.
pub fn changes(
    work: &mut Workspace,
    roots: &[Id],
    leaves: &Leaves,
    direction: &Direction,
) -> Vec<Id> {
    let mut known: HashMap<Id, Id> = direction.changes.clone().into_iter().collect();
    for turn in &leaves.turns {
        let inner = work
            .graph
            .change(&turn.vector, |id| known.get(&id).copied());
        let change = of_turned(work, turn, [inner[0], inner[1], inner[2]], direction);
        for (part, change) in turn.turned.into_iter().zip(change) {
            if !work.graph.is_early(part) {
                known.insert(part, change);
            }
        }
    }
    work.graph.change(roots, |id| known.get(&id).copied())
}

/// The change of a rotated vector, from the change of the original vector.
fn of_turned(
    work: &mut Workspace,
    turn: &Turn,
    inner: Components,
    direction: &Direction,
) -> Components {
    let body = work.turned_frame(turn);
    let Some(phi) = direction.turns.get(&body) else {
        return work.turn(inner, turn.from, turn.to);
    };
    let phi = work.components(*phi, body);
    match (body == turn.from, work.attitude(turn.from)) {
        // about an axis, phi has the same components in both axes, and the product exists already
        (true, Attitude::Axis { .. }) => {
            let swept = work.graph.cross(phi, turn.turned);
            let carried = work.turn(inner, turn.from, turn.to);
            work.graph.add_vectors(carried, swept)
        }
        (true, _) => {
            let swept = work.graph.cross(phi, turn.vector);
            let whole = work.graph.add_vectors(inner, swept);
            work.turn(whole, turn.from, turn.to)
        }
        (false, _) => {
            let swept = work.graph.cross(phi, turn.turned);
            let carried = work.turn(inner, turn.from, turn.to);
            work.graph.subtract_vectors(carried, swept)
        }
    }
}
