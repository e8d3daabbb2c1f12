//! User-defined states in constraints, whose rates are differentiated with the constraints.

use crate::errors::Errors;
use crate::model::{Constraint, Level, Meaning, Own, Variable, Workspace};
use crate::symbolic::Id;

/// A constraint of positions is differentiated twice. So the rate of a state in it is
/// differentiated once, and reported if it depends on held inputs, whose rates are unknown, or on
/// velocities, whose rates are accelerations. `derivatives` has the number of given derivatives of
/// each input.
pub fn check_states(
    work: &Workspace,
    constraints: &[Constraint],
    states: &[Own],
    derivatives: &[usize],
    errors: &mut Errors,
) -> Option<()> {
    let before = errors.count();
    let mut reported = Vec::new();
    for constraint in constraints {
        if constraint.level == Level::Velocity || reported.contains(&&constraint.place) {
            continue;
        }
        let mut found = constraint.states.iter().filter_map(|(symbol, place)| {
            let state = states.iter().find(|state| state.symbol == *symbol)?;
            Some((place, obstacle(work, state, derivatives)?))
        });
        if let Some((place, obstacle)) = found.next() {
            errors.push(*place, obstacle);
            // report it once for all components of a vector
            reported.push(&constraint.place);
        }
    }
    (errors.count() == before).then_some(())
}

/// Why the rate of a state cannot be differentiated.
fn obstacle(work: &Workspace, state: &Own, derivatives: &[usize]) -> Option<String> {
    use Variable::{AngularVelocity, AxisRate, Velocity};
    let Own { name, rate, .. } = state;
    let is_held = |id: Id| match work.meaning(id) {
        Some(Meaning::Input(input, _)) => derivatives[input] == 0,
        _ => false,
    };
    let begins = format!(
        "a constraint of positions is differentiated twice, and the rate of `{name}` follows"
    );
    if work.graph.depends_on(&[*rate], is_held) {
        return Some(format!(
            "{begins} an input at once: let this rate be a state too, declare the input as `.moving`, or write a \
             constraint of velocities"
        ));
    }
    work.depend_on(&[*rate], &[Velocity, AngularVelocity, AxisRate]).then(|| {
        format!("{begins} velocities: let this rate be a state too, or write a constraint of velocities")
    })
}
