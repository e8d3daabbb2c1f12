//! The physics: from a model to the equations of motion and what else is asked for.
//!
//! Conventions: position, velocity and linear acceleration of G in world axes;
//! angular velocity and acceleration in body axes; moments about G unless a pole is named.

mod answers;
mod balances;
mod closed_forms;
mod proofs;
mod report;
mod structure;
mod unknowns;
mod variation;

pub use answers::{
    Axes, Balance, Energy, LoadExpressions, Momentum, Partial, Resultant, Switch, Taylor,
};
pub use closed_forms::{Flow, Free, Turning};
pub use structure::{Dependence, QUANTITIES, Structure, Symmetry};
pub use unknowns::{Consistency, Reach, ReactionExpressions};
pub use variation::with_potentials;

use answers::{
    derive_balance, derive_energy, derive_momentum, derive_switches, derive_taylor, list_partial,
    solve_loads,
};
use balances::derive_accelerations;
use closed_forms::derive_flow;
use report::{classify, list_centers, list_skipped};
use structure::derive_structure;
use unknowns::{
    derive_consistency, derive_constrained, derive_inverse, derive_reach, derive_reactions,
};

use crate::errors::Errors;
use crate::model::{Model, Output, Workspace};
use crate::symbolic::{Components, Id};

/// All that is generated for a body, as expressions.
pub struct Equations {
    /// Acceleration of G, world axes.
    pub linear: Components,
    /// Angular acceleration, body axes; of a rod that of its axis, world axes.
    pub angular: Components,
    pub energy: Option<Energy>,
    pub momentum: Option<Momentum>,
    pub balance: Option<Balance>,
    /// Empty unless asked for.
    pub reactions: Vec<ReactionExpressions>,
    /// Drives of a given motion; empty unless asked for.
    pub drives: Vec<ReactionExpressions>,
    /// The motion in closed form, if it is asked for.
    pub flow: Option<Flow>,
    /// If it was asked for.
    pub taylor: Option<Taylor>,
    /// How far a state is from each constraint.
    pub constraints: Vec<Consistency>,
    /// When the equations change by a condition on time.
    pub switches: Vec<Switch>,
    /// How far it may be by rounding is a fraction of these.
    pub reach: Vec<Reach>,
    /// Loads that may have no value.
    pub partial: Vec<Partial>,
    /// What kind of body has this inertia, line by line; nothing if it is not constant.
    pub inertia_class: Vec<String>,
    /// Where uniform fields act on constant charges.
    pub charges: Vec<String>,
    /// What integrators can make use of.
    pub structure: Structure,
    /// What does not appear in the equations, and why.
    pub skipped: Vec<String>,
}

/// Derives the equations of motion and the outputs.
pub fn derive_equations(
    model: &Model,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<Equations> {
    let asked = |output: Output, model: &Model| model.outputs.contains(&output);
    let Motion {
        linear,
        angular,
        reactions: solved,
        constraints,
    } = derive_motion(model, work, errors)?;
    let drives = derive_inverse(model, work, errors)?;
    let flow = match model.flow {
        Some(place) => Some(derive_flow(model, work, place, &linear, &angular, errors)?),
        None => None,
    };
    let structure = derive_structure(model, work, &linear, &angular);
    let taylor = derive_taylor(model, work, &linear, &angular, &structure, errors);
    let energy = asked(Output::Energy, model).then(|| derive_energy(model, work));
    let momentum = asked(Output::Momentum, model).then(|| derive_momentum(model, work));
    let mut balance = asked(Output::Balance, model).then(|| derive_balance(model, work));
    if let Some(balance) = &mut balance
        && !constraints.is_empty()
    {
        solve_loads(model, work, balance, &solved);
    }
    let reactions = if asked(Output::Reactions, model) {
        solved
    } else {
        Vec::new()
    };
    let acting: Vec<Id> = linear
        .into_iter()
        .chain(angular)
        .chain(constraints.iter().flat_map(Consistency::roots))
        .collect();
    let switches = derive_switches(model, work, &acting);
    let reach = derive_reach(model, work, &constraints);
    let skipped = list_skipped(model, work, &linear, &angular, &structure);
    Some(Equations {
        linear,
        angular,
        energy,
        momentum,
        balance,
        reactions,
        drives,
        flow,
        taylor,
        constraints,
        switches,
        reach,
        partial: list_partial(model, work),
        inertia_class: classify(model, work),
        charges: list_centers(model, work),
        structure,
        skipped,
    })
}

/// Accelerations, and the reactions that go with them.
struct Motion {
    linear: Components,
    angular: Components,
    reactions: Vec<ReactionExpressions>,
    constraints: Vec<Consistency>,
}

fn derive_motion(model: &Model, work: &mut Workspace, errors: &mut Errors) -> Option<Motion> {
    if model.constraints.is_empty() {
        let (linear, angular) = derive_accelerations(model, work, errors)?;
        let reactions = derive_reactions(model, work, &linear, &angular, errors)?;
        return Some(Motion {
            linear,
            angular,
            reactions,
            constraints: Vec::new(),
        });
    }
    let solved = derive_constrained(model, work, errors)?;
    Some(Motion {
        linear: solved.linear,
        angular: solved.angular,
        reactions: solved.reactions,
        constraints: derive_consistency(model, work, &solved.constraints),
    })
}

impl Equations {
    /// All expressions that code is generated for.
    pub fn roots(&self) -> Vec<Id> {
        let mut roots = self.finite_roots();
        roots.extend(self.switches.iter().flat_map(Switch::roots));
        roots
    }

    /// Those that have to be finite: a switch that is at no time is none.
    pub fn finite_roots(&self) -> Vec<Id> {
        let mut roots: Vec<Id> = self.linear.into_iter().chain(self.angular).collect();
        if let Some(energy) = &self.energy {
            roots.extend([energy.kinetic, energy.potential]);
        }
        if let Some(momentum) = &self.momentum {
            roots.extend(
                momentum
                    .linear
                    .into_iter()
                    .chain(momentum.angular)
                    .chain(momentum.about_pole),
            );
        }
        if let Some(balance) = &self.balance {
            let wrenches = [&balance.applied, &balance.residual];
            roots.extend(
                wrenches
                    .into_iter()
                    .flat_map(|wrench| wrench.force.into_iter().chain(wrench.moment)),
            );
            roots.extend(
                balance
                    .loads
                    .iter()
                    .flat_map(|load| load.force.into_iter().chain(load.point).chain(load.moment)),
            );
        }
        roots.extend(
            self.reactions
                .iter()
                .chain(&self.drives)
                .flat_map(|reaction| reaction.vector),
        );
        roots.extend(self.flow.iter().flat_map(Flow::roots));
        roots.extend(self.taylor.iter().flat_map(Taylor::roots));
        roots.extend(self.constraints.iter().flat_map(Consistency::roots));
        let reach = self.reach.iter();
        roots.extend(reach.flat_map(|reach| reach.position.into_iter().chain([reach.velocity])));
        roots
    }
}
