//! `energy`: the kinetic energy, and that of potentials and uniform fields.

use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source};
use crate::emit::items::Addition;
use crate::families::Family;
use crate::lower::Offer;
use crate::mechanics::{self, Report, derive_energy, uniform_field};
use crate::model::{Load, Model, Workspace};
use crate::symbolic::Id;

use super::output::{Basis, Output};

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("energy")
};

#[derive(Default)]
pub struct Energy(Option<mechanics::Energy>);

impl Output for Energy {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_>) -> Option<()> {
        self.0 = Some(derive_energy(basis.model, basis.work));
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let energy = self.0.iter();
        energy
            .flat_map(|energy| [energy.kinetic, energy.potential])
            .collect()
    }

    fn describe(&self, model: &Model, work: &Workspace, report: &mut Report) {
        let (body, turns) = (model.state.body, model.motion.has_attitude());
        let has_energy = |load: &Load| {
            load.potential.is_some() || uniform_field(work, body, turns, load).is_some()
        };
        let fields = model
            .loads
            .iter()
            .filter(|load| load.family == Family::Field);
        let others = fields.filter(|load| !has_energy(load));
        report.skipped.extend(others.map(without_potential));
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        implement_energy(site, self.0.as_ref())
    }
}

/// Says that the energy has no part for a field.
pub fn without_potential(load: &Load) -> String {
    format!(
        "`{}` in the potential energy: it is not a uniform field on a point of the body",
        load.name
    )
}

/// `impl Energy for Body`, of a system too.
pub fn implement_energy(site: &Site<'_>, energy: Option<&mechanics::Energy>) -> Addition {
    let method = |of: fn(&mechanics::Energy) -> Id| {
        site.method(energy, |writer, energy| {
            Method::write(writer, &[of(energy)], |values| quote!(#(#values)*))
        })
    };
    let (kinetic, potential) = (
        method(|energy| energy.kinetic),
        method(|energy| energy.potential),
    );
    let scalar = site.shapes.scalar.kind();
    let methods = [
        ("kinetic_energy", &kinetic, &[Source::State][..], &scalar),
        ("potential_energy", &potential, &COMMON, &scalar),
    ];
    Addition::implement(site, "Energy", [quote!(), quote!()], &methods)
}
