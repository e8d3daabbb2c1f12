//! What outputs are of: a body alone, or a system. What both can be asked for is one output.

use crate::errors::{Errors, Extent};
use crate::families::Family;
use crate::mechanics::{
    Consistency, Energy, Equations, Linearization, Momentum, Reach, SystemEquations, Taylor,
    derive_energy, derive_momentum, derive_reach, derive_system_consistency, derive_system_energy,
    derive_system_momentum, derive_system_taylor, derive_taylor, linearize_body, linearize_system,
    uniform_field,
};
use crate::model::{Frame, Load, Model, Outline, System, Workspace};

/// A body alone, or a system.
pub trait Subject: Sized + 'static {
    type Equations;

    fn energy(&self, work: &mut Workspace) -> Energy;

    /// The fields that the energy does not have.
    fn fields_without_potential(&self, work: &Workspace) -> Vec<&Load>;

    fn momentum(&self, work: &mut Workspace) -> Momentum;

    /// The constraints that the motion keeps, and how far rounding reaches in each.
    fn constraints(
        &self,
        work: &mut Workspace,
        equations: &Self::Equations,
    ) -> Vec<(Consistency, Reach)>;

    /// The recurrences of series, if they exist.
    fn taylor(
        &self,
        work: &mut Workspace,
        equations: &Self::Equations,
        asked: Extent,
        errors: &mut Errors,
    ) -> Option<Taylor>;

    fn linearization(
        &self,
        outline: &Outline,
        work: &mut Workspace,
        equations: &Self::Equations,
    ) -> Linearization;
}

impl Subject for Model {
    type Equations = Equations;

    fn energy(&self, work: &mut Workspace) -> Energy {
        derive_energy(self, work)
    }

    fn fields_without_potential(&self, work: &Workspace) -> Vec<&Load> {
        let turns = self.motion.has_attitude();
        without_potential(work, self.state.body, turns, &self.loads).collect()
    }

    fn momentum(&self, work: &mut Workspace) -> Momentum {
        derive_momentum(self, work)
    }

    fn constraints(
        &self,
        work: &mut Workspace,
        equations: &Equations,
    ) -> Vec<(Consistency, Reach)> {
        let reach = derive_reach(self, work, &equations.constraints);
        equations.constraints.iter().cloned().zip(reach).collect()
    }

    fn taylor(
        &self,
        work: &mut Workspace,
        equations: &Equations,
        asked: Extent,
        errors: &mut Errors,
    ) -> Option<Taylor> {
        let structure = equations.structure(self, work);
        derive_taylor(
            self,
            work,
            asked,
            equations.accelerations,
            structure,
            errors,
        )
    }

    fn linearization(
        &self,
        outline: &Outline,
        work: &mut Workspace,
        equations: &Equations,
    ) -> Linearization {
        linearize_body(outline, self, work, equations.accelerations)
    }
}

impl Subject for System {
    type Equations = SystemEquations;

    fn energy(&self, work: &mut Workspace) -> Energy {
        derive_system_energy(self, work)
    }

    fn fields_without_potential(&self, work: &Workspace) -> Vec<&Load> {
        let bodies = self.bodies.iter();
        bodies
            .flat_map(|body| without_potential(work, body.state.body, true, &body.loads))
            .collect()
    }

    fn momentum(&self, work: &mut Workspace) -> Momentum {
        derive_system_momentum(self, work)
    }

    fn constraints(
        &self,
        work: &mut Workspace,
        equations: &SystemEquations,
    ) -> Vec<(Consistency, Reach)> {
        derive_system_consistency(self, work, equations)
    }

    fn taylor(
        &self,
        work: &mut Workspace,
        equations: &SystemEquations,
        asked: Extent,
        errors: &mut Errors,
    ) -> Option<Taylor> {
        derive_system_taylor(self, work, asked, &equations.accelerations, errors)
    }

    fn linearization(
        &self,
        outline: &Outline,
        work: &mut Workspace,
        equations: &SystemEquations,
    ) -> Linearization {
        linearize_system(outline, self, work, equations)
    }
}

/// The fields that neither are potentials nor have one.
fn without_potential<'l>(
    work: &Workspace,
    body: Frame,
    turns: bool,
    loads: &'l [Load],
) -> impl Iterator<Item = &'l Load> {
    let fields = loads.iter().filter(|load| load.family == Family::Field);
    fields.filter(move |load| {
        load.potential.is_none() && uniform_field(work, body, turns, load).is_none()
    })
}
