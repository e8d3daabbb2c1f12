//! `energy`: the kinetic energy, and the potential energy of potentials and uniform fields.

use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics::{self, Report};
use crate::model::Workspace;
use crate::symbolic::Id;

use super::output::{Basis, Output};
use super::subject::Subject;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("energy")
};

#[derive(Default)]
pub struct Energy(Option<mechanics::Energy>);

impl<S: Subject> Output<S> for Energy {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        self.0 = Some(basis.model.energy(basis.work));
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let energy = self.0.iter();
        energy
            .flat_map(|energy| [energy.kinetic, energy.potential])
            .collect()
    }

    fn describe(&self, model: &S, work: &Workspace, report: &mut Report) {
        for load in model.fields_without_potential(work) {
            let line = format!(
                "`{}` in the potential energy: it is not a uniform field on a point of the body",
                load.name
            );
            if !report.skipped.contains(&line) {
                report.skipped.push(line);
            }
        }
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let method = |of: fn(&mechanics::Energy) -> Id| {
            site.method(self.0.as_ref(), |writer, energy| {
                Method::write(writer, &[of(energy)], |values| quote!(#(#values)*))
            })
        };
        let (kinetic, potential) = (
            method(|energy| energy.kinetic),
            method(|energy| energy.potential),
        );
        let scalar = site.shapes.scalar.kind();
        let (name, of_kinetic) = if site.outline.driving.is_empty() {
            ("Energy", &[Source::State][..])
        } else {
            ("DrivenEnergy", &COMMON[..])
        };
        let methods = [
            ("kinetic_energy", &kinetic, of_kinetic, &scalar),
            ("potential_energy", &potential, &COMMON, &scalar),
        ];
        Addition::implement(site, name, [quote!(), quote!()], &methods)
    }
}
