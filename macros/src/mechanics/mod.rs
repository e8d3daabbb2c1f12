//! The physics: from a model to the equations of motion and what else is asked for.
//!
//! Conventions: position, velocity and linear acceleration of G in world axes;
//! angular velocity and acceleration in body axes; moments about G unless a pole is named.

mod about_axis;
mod active;
mod arm;
mod axes;
mod axial_torque;
mod axis_of_symmetry;
mod balance;
mod charges;
mod consistency;
mod constraints;
mod drives;
mod dyadic;
mod energy;
mod euler_equations;
mod flow;
mod free_rotation;
mod inertia_class;
mod inverse;
mod lagrange_top;
mod momentum;
mod newton_euler;
mod partial;
mod potential;
mod pushes;
mod rates;
mod reactions;
mod redundancy;
mod response;
mod rod;
mod skipped;
mod skipped_loads;
mod solvability;
mod structure;
mod switches;
mod symmetry;
mod taylor;
mod zeros;

use std::cell::OnceCell;

use crate::errors::Errors;
use crate::model::{Model, Workspace};
use crate::symbolic::{Components, Id};

pub use axes::Axes;
pub use balance::{Balance, LoadExpressions, Resultant, derive_balance};
pub use consistency::{Consistency, Reach, derive_reach};
pub use energy::{Energy, derive_energy, uniform_field};
pub use flow::{Flow, Turning, derive_flow};
pub use free_rotation::Free;
pub use inverse::derive_inverse;
pub use momentum::{Momentum, derive_momentum};
pub use partial::Partial;
pub use potential::with_potentials;
pub use structure::{Dependence, QUANTITIES, Structure};
pub use switches::Switch;
pub use symmetry::Symmetry;
pub use taylor::{Taylor, derive_taylor};

/// The equations of motion, and what is known of them.
pub struct Equations {
    /// Acceleration of G, world axes.
    pub linear: Components,
    /// Angular acceleration, body axes; of a rod that of its axis, world axes.
    pub angular: Components,
    /// The unknown loads that go with them, world axes.
    pub reactions: Vec<Components>,
    /// How far a state is from each constraint.
    pub constraints: Vec<Consistency>,
    /// When the equations change by a condition on time.
    pub switches: Vec<Switch>,
    /// Loads that may have no value.
    pub partial: Vec<Partial>,
    structure: OnceCell<Structure>,
}

/// What is told of a body, line by line.
pub struct Report {
    /// What it is like, under headings; nothing under some of them.
    pub lists: Vec<(&'static str, Vec<String>)>,
    /// What is not computed, and why.
    pub skipped: Vec<String>,
}

/// Derives the equations of motion.
pub fn derive_equations(
    model: &Model,
    work: &mut Workspace,
    errors: &mut Errors,
) -> Option<Equations> {
    let (linear, angular, reactions, constraints) = if model.constraints.is_empty() {
        let (linear, angular) = newton_euler::derive_accelerations(model, work, errors)?;
        let reactions = reactions::derive_reactions(model, work, &linear, &angular, errors)?;
        (linear, angular, reactions, Vec::new())
    } else {
        let solved = constraints::derive_constrained(model, work, errors)?;
        let constraints = consistency::derive_consistency(model, work, &solved.constraints);
        (solved.linear, solved.angular, solved.reactions, constraints)
    };
    let acting: Vec<Id> = linear
        .into_iter()
        .chain(angular)
        .chain(constraints.iter().flat_map(Consistency::roots))
        .collect();
    Some(Equations {
        linear,
        angular,
        reactions,
        switches: switches::derive_switches(model, work, &acting),
        constraints,
        partial: partial::list_partial(model, work),
        structure: OnceCell::new(),
    })
}

impl Equations {
    /// What integrators can make use of; looked for once.
    pub fn structure(&self, model: &Model, work: &mut Workspace) -> &Structure {
        let derive = || structure::derive_structure(model, work, &self.linear, &self.angular);
        self.structure.get_or_init(derive)
    }
}

/// What the equations are like, and what does not appear in them.
pub fn describe_equations(model: &Model, work: &mut Workspace, equations: &Equations) -> Report {
    let structure = equations.structure(model, work);
    let (linear, angular) = (&equations.linear, &equations.angular);
    let skipped = skipped::list_skipped(model, work, linear, angular, structure);
    let lists = vec![
        ("Inertia about G", inertia_class::classify(model, work)),
        ("Charges", charges::list_centers(model, work)),
    ];
    Report { lists, skipped }
}
