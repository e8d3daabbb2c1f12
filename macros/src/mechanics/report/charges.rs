//! The points at which uniform fields act on constant charges: (34.8), (34.9).

use crate::model::{Model, Potential, Workspace, shown};
use crate::symbolic::Number;

/// For each field: the point of its resultant, `r_0 = p / sum e`, or that there is no such point.
pub fn list_centers(model: &Model, work: &Workspace) -> Vec<String> {
    let potentials = model.potentials.list.iter();
    potentials
        .filter_map(|potential| center(model, work, potential))
        .collect()
}

fn center(model: &Model, work: &Workspace, potential: &Potential) -> Option<String> {
    let charges = potential.charges?;
    let name = &potential.name;
    let net = work.graph.as_number(charges.net)?;
    let dipole = charges.dipole[..model.motion.axes()].iter();
    let dipole = dipole.map(|id| work.graph.as_number(*id).cloned());
    let dipole = dipole.collect::<Option<Vec<_>>>()?;
    let vector = |components: &[Number]| {
        let components: Vec<String> = components.iter().map(shown).collect();
        format!("({})", components.join(", "))
    };
    if net.is_zero() {
        let dipole = vector(&dipole);
        return Some(format!(
            "`{name}`: net charge zero: a couple p x E, p = {dipole} in body axes"
        ));
    }
    let center = dipole.iter().map(|moment| moment.checked_div(net));
    let center = center.collect::<Option<Vec<_>>>()?;
    let center = vector(&center);
    Some(format!(
        "`{name}`: acts at r_0 = {center} m from G, in body axes"
    ))
}
