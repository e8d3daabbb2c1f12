//! One unit of the load of a constraint, along its gradient: a force and a moment on each body,
//! displaced separately, and loads along the freedoms of joints.
//!
//! ```text
//! of positions:   F = dg/dR   K = dg/dphi      of velocities:   F = dh/dv   K = dh/dw
//! ```

use std::collections::HashSet;

use crate::model::{Displaced, Form, Frame, Level, Turn, Workspace};
use crate::symbolic::Id;

use super::potential::{Derived, Draw, derive, expand};
use super::slopes::Slopes;

/// The unit load of each constraint, for these levels.
pub fn derive_unit_loads(
    work: &mut Workspace,
    form: &Form,
    levels: impl IntoIterator<Item = Level>,
) -> Vec<Derived> {
    let constraints = form.values.iter().zip(levels);
    let derived: Vec<Derived> = constraints
        .map(|(value, level)| match level {
            Level::Position => {
                let less = work.graph.negate(*value);
                derive(work, form, less)
            }
            Level::Velocity => by_rates(work, form, *value),
        })
        .collect();
    expand(work, form, &derived)
}

fn by_rates(work: &mut Workspace, form: &Form, value: Id) -> Derived {
    let bodies = form.bodies.iter().flat_map(Displaced::rates);
    let along = form.along.iter().map(|freedom| freedom.rate);
    let turned = form.turns.iter().flat_map(|turn: &Turn| turn.turned);
    let leaves: HashSet<Id> = bodies
        .chain(along)
        .chain(turned)
        .filter(|id| !work.graph.is_zero(*id))
        .collect();
    let mut slopes = Slopes::along_leaves(work, value, leaves);
    // each vector contains only vectors that were rotated before it
    for turn in form.turns.iter().rev() {
        let slope = slopes.take(work, turn);
        if !work.graph.is_zero_vector(&slope) {
            slopes.pass_on(work, turn, slope);
        }
    }
    let on = form.bodies.iter().map(|body| {
        let force = slopes.by(work, body.velocity);
        Draw {
            force: work.vector(Frame::WORLD, force),
            moment: slopes.by(work, body.angular_velocity),
            pull: work.graph.zeros(),
        }
    });
    let on = on.collect();
    let along = form.along.iter();
    Derived {
        energy: value,
        on,
        along: along
            .map(|freedom| slopes.by_symbol(work, freedom.rate))
            .collect(),
    }
}
