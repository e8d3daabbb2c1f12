//! Given loads that depend on the load of a constraint, such as friction. They must be linear in
//! it.

use crate::errors::Errors;
use crate::mechanics::following::{LOAD, check_linear, check_parts, unknowns_in};
use crate::model::{System, Workspace};
use crate::symbolic::{Graph, Id};

/// Reports loads that depend nonlinearly on the load of a constraint or on an acceleration.
pub fn check_followers(system: &System, work: &mut Workspace, errors: &mut Errors) -> Option<()> {
    let before = errors.count();
    let loads = system.bodies.iter().flat_map(|body| &body.loads);
    let _ = check_linear(loads, LOAD, work, errors);
    for (name, parts) in system.joints.iter().flat_map(|joint| &joint.driven_by) {
        let named = (&*name.to_string(), name.span().into());
        check_parts(work, named, parts, (LOAD, errors));
    }
    let forms = system.potentials.forms.iter();
    let energies = system
        .potentials
        .list
        .iter()
        .zip(forms.flat_map(|form| &form.values));
    let energies = energies.map(|(potential, value)| (&potential.name, *value));
    let constraints = system
        .constraints
        .list
        .iter()
        .map(|one| (&one.place, one.value));
    for (name, value) in energies.chain(constraints) {
        if !unknowns_in(work, &[value]).is_empty() {
            let message = format!(
                "`{name}` cannot depend on the load of a constraint: forces, moments and drives can"
            );
            errors.push(name.span(), message);
        }
    }
    (errors.count() == before).then_some(())
}

/// The values with these symbols set to zero, and their slopes along each symbol.
pub fn split(graph: &mut Graph, roots: &[Id], symbols: &[Id]) -> (Vec<Id>, Vec<Vec<Id>>) {
    let zero = graph.zero();
    let slopes = symbols
        .iter()
        .map(|symbol| graph.derivative(roots, *symbol));
    let slopes = slopes.collect();
    let without = graph.substitute(roots, |id| symbols.contains(&id).then_some(zero));
    (without, slopes)
}

/// Replaces symbols by their values.
pub fn replace(graph: &mut Graph, roots: &[Id], values: &[(Id, Id)]) -> Vec<Id> {
    graph.substitute(roots, |id| {
        let known = values.iter().find(|(symbol, _)| *symbol == id);
        known.map(|(_, value)| *value)
    })
}
