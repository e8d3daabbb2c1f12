//! The linearization of a system: for a tree the balances are differentiated, and solved with the
//! mass matrix; for a system held by more than a tree, the accelerations themselves.

use crate::mechanics::system::{Response, SystemEquations, unit_motion};
use crate::mechanics::variation::Direction;
use crate::model::{Group, Meaning, Outline, System, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::blocks::{Linearization, assemble};
use super::changes::{Column, Directions, changes, of_inputs};

/// The derivatives of the accelerations of a system.
pub fn linearize_system(
    outline: &Outline,
    system: &System,
    work: &mut Workspace,
    equations: &SystemEquations,
) -> Linearization {
    let mut response = Response::of(system, work, equations);
    let (accelerations, changing) = changing(system, equations, response.as_ref());
    let own = changing.len() - system.states.len();
    let mut directions = Directions::new();
    for (number, group) in outline.tangent().iter().enumerate() {
        let components = 0..group.size;
        let components = components.map(|component| direction(system, work, (group, component)));
        directions.push((Column::State(number), components.collect()));
    }
    directions.extend(of_inputs(outline, work));
    let changes = changes(
        work,
        &changing,
        &accelerations,
        &directions,
        |work, change| match &mut response {
            Some(response) => {
                let (change, rates) = change.split_at(own);
                [response.to(work, change).as_slice(), rates].concat()
            }
            None => change,
        },
    );
    let spin = |work: &Workspace, joint: usize| -> Components {
        let joint = &system.joints[system.written[joint]];
        [0, 1, 2].map(|part| {
            let rate = joint.coordinates.get(Variable::AngularVelocity, part);
            rate.unwrap_or(work.graph.zero())
        })
    };
    assemble(outline, work, accelerations, &changes, spin)
}

/// The accelerations in the order of the state, and the expressions that are differentiated for
/// them; the rates of user-defined states come after both.
pub fn changing(
    system: &System,
    equations: &SystemEquations,
    response: Option<&Response>,
) -> (Vec<Id>, Vec<Id>) {
    let (accelerations, changing) = if let Some(response) = response {
        (response.accelerations.clone(), response.lacking.clone())
    } else {
        let written = system.written.iter();
        let accelerations = written.flat_map(|joint| equations.accelerations[*joint].clone());
        let accelerations: Vec<Id> = accelerations.collect();
        (accelerations.clone(), accelerations)
    };
    let rates = system.states.iter().map(|state| state.rate);
    [accelerations, changing]
        .map(|all| all.into_iter().chain(rates.clone()).collect())
        .into()
}

/// A component of the tangent space changes by one.
fn direction(
    system: &System,
    work: &mut Workspace,
    (group, component): (&Group, usize),
) -> Direction {
    if group.variable == Variable::Own {
        let own = work.symbol_of(Meaning::Own(group.first));
        return Direction::of_symbol(work, own);
    }
    let joint = &system.joints[system.written[group.joint]];
    let part = group.first + component;
    match group.variable {
        Variable::Position => unit_motion(system, work, joint, (Variable::Velocity, part)),
        Variable::Angle | Variable::Quaternion => {
            unit_motion(system, work, joint, (Variable::AngularVelocity, part))
        }
        rate => Direction::of_symbol(work, joint.coordinates.get(rate, part)),
    }
}
