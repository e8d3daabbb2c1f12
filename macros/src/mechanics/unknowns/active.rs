//! Where a constraint says something: one that is constant on some branch says nothing there.

use crate::mechanics::proofs::all_vanish;
use crate::model::Workspace;
use crate::symbolic::Id;

use super::constrained::Constrained;

/// Conditions that are looked at together.
const MOST: usize = 6;

/// Where the gradient of a constraint is not proved to be zero; `None` is everywhere.
pub fn active(work: &mut Workspace, constraint: &Constrained) -> Option<Id> {
    let gradient = [constraint.rates.linear, constraint.rates.angular].concat();
    let conditions = work.graph.conditions(&gradient);
    if conditions.is_empty() || conditions.len() > MOST {
        return None;
    }
    let mut idle = work.graph.truth(false);
    for outcomes in 0..1_usize << conditions.len() {
        let holds = |condition: Id| {
            let place = conditions.iter().position(|known| *known == condition);
            place.is_some_and(|place| outcomes >> place & 1 == 1)
        };
        let there = work.graph.on_side(&gradient, holds);
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
