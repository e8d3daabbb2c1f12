//! What outputs are derived for: a single body or a system. Outputs common to both are written
//! once.

use std::iter;

use crate::emit::code::Shapes;
use crate::emit::items::Equated;
use crate::errors::{Errors, Extent};
use crate::families::Family;
use crate::mechanics::{
    Balance, Consistency, Differentiated, Energy, Equations, Momentum, Reach, Regressor, Report,
    SystemEquations, Tangent, Taylor, check_followers, derive_balance, derive_energy,
    derive_equations, derive_momentum, derive_reach, derive_regressor, derive_system,
    derive_system_balances, derive_system_consistency, derive_system_energy, derive_system_held,
    derive_system_momentum, derive_system_regressors, derive_system_taylor, derive_taylor,
    describe_equations, describe_system, differentiated_body, differentiated_system, uniform_field,
    with_potentials, with_system_potentials,
};
use crate::model::{
    Checks, Defaults, Frame, Load, Member, Model, Outline, Own, Property, Substance, System,
    Workspace,
};
use crate::symbolic::Id;

/// A single body, or a system.
pub trait Subject: Tangent + Sized + 'static {
    type Equations;

    /// Its equations of motion, with potentials turned into loads. `None` if there are none; the
    /// errors say why.
    fn derive(self, work: &mut Workspace, errors: &mut Errors) -> Option<(Self, Self::Equations)>;

    /// The properties of its equations, and the dropped terms.
    fn describe(&self, work: &mut Workspace, equations: &Self::Equations) -> Report;

    /// Its accelerations in the order of the state, and the times at which they switch.
    fn equated(&self, outline: &Outline, equations: &Self::Equations) -> Equated;

    /// The mass and inertia of its bodies, also about the points about which they swing.
    fn substances(&self, work: &mut Workspace) -> Vec<Substance>;

    /// The properties of its links and cables, and the inertia of its bodies with added mass.
    fn properties(&self) -> &[Property];

    fn defaults(&self) -> &Defaults;

    /// Its claims about the motion.
    fn checks(&self) -> &Checks;

    /// The symbols of accelerations and loads that are solved for, each with its solution.
    fn solved(&self, work: &Workspace, equations: &Self::Equations) -> Vec<(Id, Id)>;

    /// The symbols of the quantities that checks may use, each with its expression.
    fn answers(&self, work: &mut Workspace, equations: &Self::Equations) -> Vec<(Id, Id)> {
        let Some(asked) = self.checks().answers else {
            return Vec::new();
        };
        let (energy, momentum) = (self.energy(work), self.momentum(work));
        let linear = asked.linear_momentum.into_iter().zip(momentum.linear);
        let angular = asked.angular_momentum.into_iter().zip(momentum.angular);
        let energies = [
            (asked.kinetic, energy.kinetic),
            (asked.potential, energy.potential),
        ];
        let held = self.held(work, equations);
        let all = self.solved(work, equations).into_iter().chain(energies);
        all.chain(linear).chain(angular).chain(held).collect()
    }

    /// The symbols of the loads that joints carry, each with its expression.
    fn held(&self, _: &mut Workspace, _: &Self::Equations) -> Vec<(Id, Id)> {
        Vec::new()
    }

    fn energy(&self, work: &mut Workspace) -> Energy;

    /// The fields that do not contribute to the energy.
    fn fields_without_potential(&self, work: &Workspace) -> Vec<&Load>;

    fn momentum(&self, work: &mut Workspace) -> Momentum;

    /// The balances of each body, in the order of the outline.
    fn balances(
        &self,
        work: &mut Workspace,
        equations: &Self::Equations,
        outline: &Outline,
    ) -> Vec<Balance>;

    /// The constraints of the motion, each with a bound of its rounding error.
    fn constraints(
        &self,
        work: &mut Workspace,
        equations: &Self::Equations,
    ) -> Vec<(Consistency, Reach)>;

    /// The recurrences of its Taylor series, if they exist.
    fn taylor(
        &self,
        work: &mut Workspace,
        equations: &Self::Equations,
        asked: Extent,
        errors: &mut Errors,
    ) -> Option<Taylor>;

    /// The expressions that a linearization differentiates.
    fn differentiated(&self, work: &mut Workspace, equations: &Self::Equations) -> Differentiated;

    /// The regressor of each body, in the order of the outline.
    fn regressors(
        &self,
        outline: &Outline,
        work: &mut Workspace,
        equations: &Self::Equations,
    ) -> Vec<Regressor>;

    /// Whether the coordinates of a joint, given by its index in the state, are in world axes.
    fn is_in_world(&self, joint: usize) -> bool;
}

impl Subject for Model {
    type Equations = Equations;

    fn derive(self, work: &mut Workspace, errors: &mut Errors) -> Option<(Self, Equations)> {
        derive_equations(with_potentials(self, work), work, errors)
    }

    fn describe(&self, work: &mut Workspace, equations: &Equations) -> Report {
        describe_equations(self, work, equations)
    }

    fn equated(&self, outline: &Outline, equations: &Equations) -> Equated {
        Equated {
            accelerations: [
                Shapes::of(outline).pair_part(&equations.accelerations),
                rates(&self.states),
            ]
            .concat(),
            switches: equations.switches.clone(),
            partial: equations.partial.clone(),
        }
    }

    fn substances(&self, work: &mut Workspace) -> Vec<Substance> {
        let (body, graph) = (self.substance(), &mut work.graph);
        let held = self.state.support.and_then(|support| {
            let axis = self.hinge(graph);
            body.held(graph, support.offset, axis)
        });
        iter::once(body).chain(held).collect()
    }

    fn properties(&self) -> &[Property] {
        &[]
    }

    fn defaults(&self) -> &Defaults {
        &self.defaults
    }

    fn checks(&self) -> &Checks {
        &self.checks
    }

    fn solved(&self, work: &Workspace, equations: &Equations) -> Vec<(Id, Id)> {
        equations.solved(self, work)
    }

    fn energy(&self, work: &mut Workspace) -> Energy {
        derive_energy(self, work)
    }

    fn fields_without_potential(&self, work: &Workspace) -> Vec<&Load> {
        without_potential(work, self.state.body, &self.loads).collect()
    }

    fn momentum(&self, work: &mut Workspace) -> Momentum {
        derive_momentum(self, work)
    }

    fn balances(&self, work: &mut Workspace, equations: &Equations, _: &Outline) -> Vec<Balance> {
        vec![derive_balance(self, work, &equations.reactions)]
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

    fn differentiated(&self, _: &mut Workspace, equations: &Equations) -> Differentiated {
        differentiated_body(self, equations.accelerations)
    }

    fn regressors(&self, _: &Outline, work: &mut Workspace, _: &Equations) -> Vec<Regressor> {
        vec![derive_regressor(self, work)]
    }

    fn is_in_world(&self, _: usize) -> bool {
        true
    }
}

impl Subject for System {
    type Equations = SystemEquations;

    fn derive(self, work: &mut Workspace, errors: &mut Errors) -> Option<(Self, SystemEquations)> {
        check_followers(&self, work, errors)?;
        let mut system = with_system_potentials(self, work);
        let equations = derive_system(&system, work);
        system.properties.extend(equations.conditions());
        equations.check(&system, work, errors)?;
        Some((system, equations))
    }

    fn describe(&self, work: &mut Workspace, equations: &SystemEquations) -> Report {
        describe_system(self, work, equations)
    }

    fn equated(&self, _: &Outline, equations: &SystemEquations) -> Equated {
        // the state has the joints in the order in which they are written, the tree has each after
        // its carrier
        let written = self.written.iter();
        let accelerations = written.flat_map(|joint| equations.accelerations[*joint].clone());
        Equated {
            accelerations: accelerations.chain(rates(&self.states)).collect(),
            switches: equations.switches.clone(),
            partial: equations.partial.clone(),
        }
    }

    fn substances(&self, work: &mut Workspace) -> Vec<Substance> {
        let mut all: Vec<Substance> = self.bodies.iter().map(Member::substance).collect();
        for joint in &self.joints {
            let axis = joint.directions.first().copied();
            let held = all[joint.carried].held(&mut work.graph, joint.pin, axis);
            all.extend(held);
        }
        all
    }

    fn properties(&self) -> &[Property] {
        &self.properties
    }

    fn defaults(&self) -> &Defaults {
        &self.defaults
    }

    fn checks(&self) -> &Checks {
        &self.checks
    }

    fn solved(&self, _: &Workspace, equations: &SystemEquations) -> Vec<(Id, Id)> {
        equations.solved(self)
    }

    fn held(&self, work: &mut Workspace, equations: &SystemEquations) -> Vec<(Id, Id)> {
        derive_system_held(self, work, equations)
    }

    fn energy(&self, work: &mut Workspace) -> Energy {
        derive_system_energy(self, work)
    }

    fn fields_without_potential(&self, work: &Workspace) -> Vec<&Load> {
        let bodies = self.bodies.iter();
        bodies
            .flat_map(|body| without_potential(work, body.state.body, &body.loads))
            .collect()
    }

    fn momentum(&self, work: &mut Workspace) -> Momentum {
        derive_system_momentum(self, work)
    }

    fn balances(
        &self,
        work: &mut Workspace,
        equations: &SystemEquations,
        outline: &Outline,
    ) -> Vec<Balance> {
        let all = derive_system_balances(self, work, equations, &outline.holding);
        self.as_written(outline, all)
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

    fn differentiated(&self, work: &mut Workspace, equations: &SystemEquations) -> Differentiated {
        differentiated_system(self, work, equations)
    }

    fn regressors(
        &self,
        outline: &Outline,
        work: &mut Workspace,
        equations: &SystemEquations,
    ) -> Vec<Regressor> {
        self.as_written(outline, derive_system_regressors(self, work, equations))
    }

    fn is_in_world(&self, joint: usize) -> bool {
        let joint = self.written.get(joint);
        joint.is_some_and(|joint| self.joints[*joint].is_in_world())
    }
}

impl System {
    /// One item for each body, sorted into the order of the outline.
    fn as_written<T>(&self, outline: &Outline, all: Vec<T>) -> Vec<T> {
        let mut named: Vec<_> = self.bodies.iter().map(|body| &body.name).zip(all).collect();
        named.sort_by_key(|(name, _)| outline.bodies.iter().position(|body| body == *name));
        named.into_iter().map(|(_, one)| one).collect()
    }
}

fn rates(states: &[Own]) -> Vec<Id> {
    states.iter().map(|state| state.rate).collect()
}

/// The fields that are neither potentials nor derivable from one.
fn without_potential<'l>(
    work: &Workspace,
    body: Frame,
    loads: &'l [Load],
) -> impl Iterator<Item = &'l Load> {
    let fields = loads.iter().filter(|load| load.family == Family::Field);
    fields.filter(move |load| load.potential.is_none() && uniform_field(work, body, load).is_none())
}
