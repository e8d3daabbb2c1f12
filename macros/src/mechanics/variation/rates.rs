//! Rates: how an expression changes as the body moves.
//!
//! ```text
//! de/dt = rate + linear . a + angular . w'
//! ```

use crate::model::{Axis, Model, Pair, Variable, Workspace};
use crate::symbolic::Id;

use super::direction::Direction;
use super::slopes::Slopes;

/// The time derivative of an expression. Inputs are constant unless they are `.moving`.
pub struct Rates {
    /// The part that does not depend on the accelerations.
    pub rate: Id,
    /// The factors of the accelerations; for a rod, of an angular acceleration without spin.
    pub factors: Pair,
}

pub fn rates(model: &Model, work: &mut Workspace, value: Id) -> Rates {
    let slopes = Slopes::of(work, value);
    let (body, motion) = (model.state.body, Direction::motion(model, work));
    let mut rate = slopes.along(work, &motion);
    let mut angular = slopes.by_variable(work, body, Variable::AngularVelocity);
    if let Some(Axis { unit, rate: moving }) = model.state.axis {
        // u'' = w' x u - u'^2 u: a slope g along u' is a slope `u x g` along w, and adds to the
        // rate
        let slope = slopes.by(work, moving);
        let graph = &mut work.graph;
        angular = graph.cross(unit, slope);
        let (along, square) = (graph.dot(unit, slope), graph.norm_squared(moving));
        let held = graph.multiply(square, along);
        rate = graph.subtract(rate, held);
    }
    Rates {
        rate,
        factors: Pair {
            linear: slopes.by_variable(work, body, Variable::Velocity),
            angular,
        },
    }
}
