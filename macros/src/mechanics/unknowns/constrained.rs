//! A constraint with its derivatives, and the branches on which it is not trivial. Where it is
//! constant on a branch, it has no gradient.

use proc_macro2::Ident;

use crate::mechanics::proofs::all_vanish;
use crate::mechanics::variation::{Rates, rates};
use crate::model::{Level, Meaning, Model, Variable, Workspace};
use crate::symbolic::{Graph, Id, Node};

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

impl Constrained {
    pub fn level(&self) -> Level {
        match self.position {
            Some(_) => Level::Position,
            None => Level::Velocity,
        }
    }
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

/// Where a constraint is not trivial.
#[derive(Clone, Default)]
pub struct Activity {
    /// The branches on which its gradient is not proved to be zero; `None` if these are all.
    pub condition: Option<Id>,
    /// Whether it changes on one of the other branches, where no load can keep it.
    pub is_lost: bool,
}

impl Activity {
    /// Whether the constraint is trivial everywhere.
    pub fn is_nowhere(&self, graph: &Graph) -> bool {
        let condition = self.condition.map(|condition| graph.node(condition));
        matches!(condition, Some(Node::Truth(false)))
    }
}

/// Where a constraint with this gradient is not trivial. Its rate is that of a position, and its
/// drift is the derivative of a velocity without accelerations.
pub fn activity(
    work: &mut Workspace,
    gradient: &[Id],
    level: Level,
    [rate, drift]: [Id; 2],
) -> Activity {
    let pieces = work.graph.in_pieces(gradient);
    if work.graph.outermost_condition(&pieces).is_none() {
        let is_nowhere = pieces != gradient && all_vanish(work, &pieces);
        return Activity {
            condition: is_nowhere.then(|| work.graph.truth(false)),
            is_lost: false,
        };
    }
    // where the gradient is zero, so is what velocities change
    let change = match level {
        Level::Position => at_rest(work, rate),
        Level::Velocity => drift,
    };
    let roots = work.graph.in_pieces(&[gradient, &[change]].concat());
    let mut search = Search {
        work,
        length: gradient.len(),
        left: MOST_CONDITIONS,
        is_lost: false,
    };
    let idle = search.idle(&roots);
    let is_lost = search.is_lost;
    let graph = &mut work.graph;
    let condition = (idle != graph.truth(false)).then(|| graph.not(idle));
    Activity { condition, is_lost }
}

/// An expression without velocities.
fn at_rest(work: &mut Workspace, root: Id) -> Id {
    let zero = work.graph.zero();
    let is_rate = |id: &Id| match work.meaning(*id) {
        Some(Meaning::Of(_, variable, _)) => variable.is_rate() && variable != Variable::Own,
        _ => false,
    };
    let rates = work.graph.nodes_of(&[root]).into_iter().filter(is_rate);
    let rates: Vec<(Id, Id)> = rates.map(|rate| (rate, zero)).collect();
    let [root] = work.graph.replaced([root], &rates);
    root
}

/// The search for branches on which a gradient is zero.
struct Search<'w> {
    work: &'w mut Workspace,
    /// The number of roots that are the gradient; the last is the change by itself.
    length: usize,
    /// How many conditions may still be decided.
    left: usize,
    is_lost: bool,
}

impl Search<'_> {
    /// Where a gradient is proved to be zero.
    fn idle(&mut self, roots: &[Id]) -> Id {
        let (gradient, changes) = roots.split_at(self.length);
        let condition = self.work.graph.outermost_condition(gradient);
        let Some(condition) = condition.filter(|_| self.left > 0) else {
            let is_idle = all_vanish(self.work, gradient);
            // conditions that are left may exclude each other, or those that are decided
            let is_decided = self.work.graph.outermost_condition(changes).is_none();
            self.is_lost |= is_idle && is_decided && !all_vanish(self.work, changes);
            return self.work.graph.truth(is_idle);
        };
        self.left -= 1;
        let [there, elsewhere] = [true, false].map(|holds| {
            let side = self.work.graph.on_side(roots, condition, holds);
            self.idle(&side)
        });
        if there == elsewhere {
            return there;
        }
        let graph = &mut self.work.graph;
        let (always, opposite) = (graph.truth(true), graph.not(condition));
        if there == always {
            return graph.or(condition, elsewhere);
        }
        if elsewhere == always {
            return graph.or(opposite, there);
        }
        let there = graph.and(condition, there);
        let elsewhere = graph.and(opposite, elsewhere);
        graph.or(there, elsewhere)
    }
}
