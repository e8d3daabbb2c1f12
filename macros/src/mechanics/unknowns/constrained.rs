//! A constraint with its derivatives, and where it says something: one that is constant on some
//! branch says nothing there.

use proc_macro2::Ident;

use crate::mechanics::proofs::all_vanish;
use crate::mechanics::variation::{Rates, rates};
use crate::model::{Level, Model, Workspace};
use crate::symbolic::Id;

/// Conditions that are looked at together.
const MOST: usize = 6;

/// A constraint with its derivatives.
pub struct Constrained {
    pub name: String,
    pub place: Ident,
    /// `g`; a constraint of velocities has none.
    pub position: Option<Id>,
    /// `h`
    pub velocity: Id,
    /// `b`, and `A` by its linear and its angular part.
    pub rates: Rates,
}

/// Each constraint with what it says of velocities and accelerations.
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

/// Where the gradient of a constraint is not proved to be zero; `None` is everywhere.
pub fn active(work: &mut Workspace, gradient: &[Id]) -> Option<Id> {
    let conditions = work.graph.conditions(gradient);
    if conditions.is_empty() || conditions.len() > MOST {
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
