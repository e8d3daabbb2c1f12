//! Where a constraint says something: one that is constant on some branch says nothing there.

use crate::model::Model;
use crate::symbolic::Id;

use super::constraints::Constrained;
use super::zeros::all_vanish;

/// Conditions that are looked at together.
const MOST: usize = 6;

/// Where the gradient of a constraint is not proved to be zero; `None` is everywhere.
pub fn active(model: &mut Model, constraint: &Constrained) -> Option<Id> {
    let gradient = [constraint.rates.linear, constraint.rates.angular].concat();
    let conditions = model.frames.graph.conditions(&gradient);
    if conditions.is_empty() || conditions.len() > MOST {
        return None;
    }
    let mut idle = model.frames.graph.truth(false);
    for outcomes in 0..1_usize << conditions.len() {
        let holds = |condition: Id| {
            let place = conditions.iter().position(|known| *known == condition);
            place.is_some_and(|place| outcomes >> place & 1 == 1)
        };
        let there = model.frames.graph.on_side(&gradient, holds);
        if all_vanish(model, &there) {
            let graph = &mut model.frames.graph;
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
    let graph = &mut model.frames.graph;
    let never = graph.truth(false);
    (idle != never).then(|| graph.not(idle))
}
