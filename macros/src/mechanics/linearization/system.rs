//! The linearization of a system. For a tree, the balances are differentiated and solved for the
//! change of the accelerations. For a system held by more than a tree, the accelerations themselves
//! are differentiated.

use crate::mechanics::system::{Response, SystemEquations, unit_motion};
use crate::mechanics::variation::Direction;
use crate::model::{Group, Meaning, System, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::differentiated::{Differentiated, Tangent};

/// The expressions that are differentiated for a system.
pub fn differentiated_system(
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Differentiated {
    if let Some(response) = Response::of(system, work, equations) {
        return Differentiated::by_balances(response, &system.states);
    }
    let written = system.written.iter();
    let accelerations = written.flat_map(|joint| equations.accelerations[*joint].clone());
    let accelerations: Vec<Id> = accelerations.collect();
    Differentiated::directly(accelerations, &system.states)
}

impl Tangent for System {
    fn direction(&self, work: &mut Workspace, group: &Group, component: usize) -> Direction {
        if group.variable == Variable::Own {
            let own = work.symbol_of(Meaning::Own(group.first));
            return Direction::of_symbol(work, own);
        }
        let joint = &self.joints[self.written[group.joint]];
        let part = group.first + component;
        match group.variable {
            Variable::Position => unit_motion(self, work, joint, (Variable::Velocity, part)),
            Variable::Angle | Variable::Quaternion => {
                unit_motion(self, work, joint, (Variable::AngularVelocity, part))
            }
            rate => Direction::of_symbol(work, joint.coordinates.get(rate, part)),
        }
    }

    fn spin(&self, work: &Workspace, joint: usize) -> Components {
        let joint = &self.joints[self.written[joint]];
        [0, 1, 2].map(|part| {
            let rate = joint.coordinates.get(Variable::AngularVelocity, part);
            rate.unwrap_or(work.graph.zero())
        })
    }
}
