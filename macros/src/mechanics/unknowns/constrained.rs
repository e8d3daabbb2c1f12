//! A constraint with its derivatives, and the branches on which it is not trivial. Where it is
//! constant on a branch, it has no gradient.

use proc_macro2::Ident;

use crate::mechanics::proofs::all_vanish;
use crate::mechanics::variation::{Rates, rates};
use crate::model::{Level, Model, Workspace};
use crate::symbolic::Id;

/// The most conditions that are examined together.
const MOST_CONDITIONS: usize = 6;

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
    let conditions = work.graph.conditions(gradient);
    if conditions.is_empty() || conditions.len() > MOST_CONDITIONS {
        return None;
    }
    let mut idle = work.graph.truth(false);
    for outcomes in 0..1_usize << conditions.len() {
        let holds = |condition: Id| {
            let place = conditions.iter().position(|known| *known == condition);
            place.is_some_and(|place| outcomes >> place & 1 == 1)
        };
        let there = work.graph.on_side(gradient, holds);
        if all_vanish(work, &there) {
            let graph = &mut work.graph;
            let mut all = graph.truth(true);
            for condition in &conditions {
                let outcome = if holds(*condition) {
                    *condition
                } else {
                    graph.not(*condition)
                };
                all = graph.and(all, outcome);
            }
            idle = graph.or(idle, all);
        }
    }
    let graph = &mut work.graph;
    let never = graph.truth(false);
    (idle != never).then(|| graph.not(idle))
}
