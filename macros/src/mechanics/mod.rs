//! The physics: from a model to the equations of motion, and to the expressions of outputs.
//!
//! Conventions: position, velocity and linear acceleration of G are in world axes; angular velocity
//! and acceleration are in body axes; moments are about G unless a pole is named.

mod answers;
mod balances;
mod closed_forms;
mod following;
mod linearization;
mod proofs;
mod report;
mod structure;
mod system;
pub mod tree;
mod unknowns;
mod variation;

pub use answers::{
    Axes, Balance, Energy, LoadExpressions, Momentum, Partial, Regressor, Resultant, Switch,
    Taylor, derive_balance, derive_energy, derive_momentum, derive_regressor, derive_taylor,
    inertial_parameters,
};
pub use balances::uniform_field;
pub use closed_forms::{Flow, Free, Rotation, derive_flow};
pub use linearization::{
    Block, Column, Differentiated, Linearization, Row, Tangent, differentiated_body,
    differentiated_system, linearize, sensitivity,
};
pub use report::{Law, Left, Part, Term};
pub use structure::{Dependence, QUANTITIES, Structure, Symmetry};
pub use system::{
    Counter, Course, Inertias, Jacobian, SystemEquations, SystemFlow, check_followers,
    derive_inertias, derive_jacobians, derive_system, derive_system_balances,
    derive_system_consistency, derive_system_driving, derive_system_energy, derive_system_flow,
    derive_system_held, derive_system_inverse, derive_system_momentum, derive_system_open,
    derive_system_reactions, derive_system_regressors, derive_system_release, derive_system_taylor,
    describe_system,
};
pub use unknowns::{Consistency, Reach, derive_inverse, derive_reach};
pub use variation::{with_potentials, with_system_potentials};

use std::cell::OnceCell;

use answers::{derive_switches, list_partial, loads};
use balances::{EulerForm, derive_accelerations};
use following::{REACTION, check_linear, settle, with_settled};
use report::{classify, list_centers, list_laws, list_skipped};
use structure::derive_structure;
use unknowns::{derive_consistency, derive_constrained, derive_reactions};

use crate::errors::Errors;
use crate::model::{Frame, Meaning, Model, Pair, Variable, Workspace};
use crate::symbolic::{Components, Id};

/// The equations of motion, and their properties.
pub struct Equations {
    /// For a rod, the acceleration of its axis takes the place of the angular one.
    pub accelerations: Pair,
    /// The form of Euler's equations, if these are solved in space.
    form: Option<EulerForm>,
    /// The solutions for unknown reactions, in world axes.
    pub reactions: Vec<Components>,
    /// How far a state is from satisfying each constraint.
    pub constraints: Vec<Consistency>,
    /// The times at which the equations change because of a condition on time.
    pub switches: Vec<Switch>,
    /// Loads that may have no value.
    pub partial: Vec<Partial>,
    structure: OnceCell<Structure>,
}

/// The documentation of a body, line by line.
pub struct Report {
    /// The balances of its bodies.
    pub laws: Vec<Law>,
    /// Its properties, under headings. Some lists may be empty.
    pub lists: Vec<(&'static str, Vec<String>)>,
    /// The terms that are not computed, and the reasons.
    pub skipped: Vec<String>,
}

/// Derives the equations of motion. In the returned model, loads that depend on accelerations have
/// become functions of the state.
pub fn derive_equations(
    model: Model,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<(Model, Equations)> {
    check_linear(model.loads.iter(), REACTION, work, errors)?;
    let (accelerations, form, constrained) = if model.constraints.is_empty() {
        let (accelerations, form) = derive_accelerations(&model, work, errors)?;
        (accelerations, form, None)
    } else {
        let solved = derive_constrained(&model, work, errors)?;
        let constraints = derive_consistency(&model, work, &solved.constraints);
        let constrained = Some((solved.reactions, constraints));
        (solved.accelerations, solved.form, constrained)
    };
    let settled = settle(&model, work, accelerations, errors)?;
    let (model, accelerations) = (with_settled(model, work, &settled), settled.accelerations);
    let (reactions, constraints) = match constrained {
        None => (
            derive_reactions(&model, work, accelerations, errors)?,
            Vec::new(),
        ),
        Some((reactions, constraints)) => {
            let reactions = reactions.into_iter();
            let reactions = reactions.map(|one| settled.put_into(&mut work.graph, one));
            (reactions.collect(), constraints)
        }
    };
    let mut acting = accelerations.entries();
    acting.extend(constraints.iter().flat_map(Consistency::roots));
    acting.extend(model.states.iter().map(|state| state.rate));

    let equations = Equations {
        accelerations,
        form,
        reactions,
        switches: derive_switches(model.state.time, &model.derivatives, work, &acting),
        constraints,
        partial: list_partial(loads(&model, work), work),
        structure: OnceCell::new(),
    };
    Some((model, equations))
}

impl Equations {
    /// The symbols of accelerations and reactions, each with its solution.
    pub fn solved(&self, model: &Model, work: &Workspace) -> Vec<(Id, Id)> {
        let Pair { linear, angular } = self.accelerations;
        let turning = if model.motion.is_line() {
            Variable::AxisAcceleration
        } else {
            Variable::AngularAcceleration
        };
        let by_variable = [(Variable::LinearAcceleration, linear), (turning, angular)];
        let accelerations = by_variable.into_iter().flat_map(|(variable, found)| {
            let parts = found.into_iter().enumerate();
            parts.filter_map(move |(axis, value)| {
                let meaning = Meaning::Of(model.state.body, variable, axis);
                Some((work.symbol_of(meaning)?, value))
            })
        });
        let reactions = model.reactions.iter().zip(&self.reactions);
        let reactions = reactions.flat_map(|(reaction, found)| {
            let symbols = work.part(reaction.symbols, Frame::WORLD);
            symbols.into_iter().zip(*found)
        });
        accelerations.chain(reactions).collect()
    }

    /// The properties that integrators can use, derived once.
    pub fn structure(&self, model: &Model, work: &mut Workspace) -> &Structure {
        let derive = || derive_structure(model, work, self.accelerations);
        self.structure.get_or_init(derive)
    }
}

/// The properties of the equations, and the terms that do not appear in them.
pub fn describe_equations(model: &Model, work: &mut Workspace, equations: &Equations) -> Report {
    let structure = equations.structure(model, work);
    let (accelerations, form) = (equations.accelerations, equations.form);
    let skipped = list_skipped(model, work, accelerations, form, structure);
    let lists = vec![
        ("Inertia about G", classify(model, work)),
        ("Charges", list_centers(model, work)),
    ];
    let laws = list_laws(model, work);
    Report {
        laws,
        lists,
        skipped,
    }
}
