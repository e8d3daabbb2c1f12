//! A constraint with its derivatives, and the branches on which it is not trivial. Where it is
//! constant on a branch, it has no gradient.

use proc_macro2::Ident;

use crate::mechanics::proofs::all_vanish;
use crate::mechanics::variation::{Rates, rates};
use crate::model::{Level, Model, Workspace};
use crate::symbolic::Id;

/// The most conditions that are decided, one inside the other or side by side: eight that have nothing
/// to do with each other.
const MOST_CONDITIONS: usize = 255;

/// A constraint with its derivatives.
pub struct Constrained {
    pub name: String,
    pub place: Ident,
    /// `g`; `None` for a constraint of velocities.
    pub position: Option<Id>,
    /// `h`
    pub velocity: Id,
    /// `b`, and the linear and angular parts of `A`.
    pub rates: Rates,
}

/// All constraints, with their conditions on velocities and accelerations.
pub fn differentiate(model: &Model, work: &mut Workspace) -> Vec<Constrained> {
    let constraints = model.constraints.iter().map(|constraint| {
        let value = constraint.value;
        let (position, velocity) = match constraint.level {
            Level::Position => (Some(value), rates(model, work, value).rate),
            Level::Velocity => (None, value),
        };
        Constrained {
            name: constraint.name.clone(),
            place: constraint.place.clone(),
            position,
            velocity,
            rates: rates(model, work, velocity),
        }
    });
    constraints.collect()
}

/// The branches on which the gradient of a constraint is not proved to be zero; `None` if these are
/// all.
pub fn active(work: &mut Workspace, gradient: &[Id]) -> Option<Id> {
    work.graph.outermost_condition(gradient)?;
    let mut left = MOST_CONDITIONS;
    let idle = idle(work, gradient, &mut left);
    let graph = &mut work.graph;
    (idle != graph.truth(false)).then(|| graph.not(idle))
}

/// Where a gradient is proved to be zero; `left` is how many conditions may still be decided.
fn idle(work: &mut Workspace, gradient: &[Id], left: &mut usize) -> Id {
    let condition = work.graph.outermost_condition(gradient);
    let Some(condition) = condition.filter(|_| *left > 0) else {
        let is_idle = all_vanish(work, gradient);
        return work.graph.truth(is_idle);
    };
    *left -= 1;
    let [there, elsewhere] = [true, false].map(|holds| {
        let side = work.graph.on_side(gradient, condition, holds);
        idle(work, &side, left)
    });
    if there == elsewhere {
        return there;
    }
    let graph = &mut work.graph;
    let opposite = graph.not(condition);
    let there = graph.and(condition, there);
    let elsewhere = graph.and(opposite, elsewhere);
    graph.or(there, elsewhere)
}
