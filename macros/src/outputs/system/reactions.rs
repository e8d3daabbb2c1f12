//! `reactions`, of some joints `reactions(elbow)`: force and moment of joints on what they carry.

use proc_macro2::Ident;
use quote::quote;

use crate::emit::code::{COMMON, Method, Site};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics::derive_system_reactions;
use crate::model::System;
use crate::outputs::output::{Basis, Output};
use crate::symbolic::{Components, Id};

use super::by_name::ByName;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("reactions")
};

/// Force and moment of each joint, by name.
#[derive(Default)]
pub struct Reactions(Option<Vec<(Ident, [Components; 2])>>);

impl Output<System> for Reactions {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        let loads = derive_system_reactions(basis.work, basis.equations);
        let joints = basis.model.joints.iter().zip(loads);
        let held =
            joints.filter(|(joint, _)| !joint.kind.is_free() && basis.outline.is_held(&joint.name));
        let held: Vec<_> = held
            .map(|(joint, load)| (joint.name.clone(), load))
            .collect();
        for (name, [force, moment]) in &held {
            let labels = &mut basis.work.labels;
            labels.vector(&format!("{name}_force"), *force);
            labels.vector(&format!("{name}_moment"), *moment);
        }
        self.0 = Some(held);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let held = self.0.iter().flatten();
        held.flat_map(|(_, pair)| pair.concat()).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let held = self.0.as_ref();
        let held = held.map(|held| held.iter().map(|(name, _)| name.clone()).collect());
        let names: Vec<Ident> = held.unwrap_or_else(|| {
            let joints = outline.joints.iter().map(|joint| joint.name.clone());
            joints.filter(|name| outline.is_held(name)).collect()
        });
        let wrench = shapes.wrench_type();
        let by_name = ByName {
            suffix: "Reactions",
            doc: format!(
                " What the joints of [`{}`] do to the bodies that they carry, at their points there, world axes; drives included.",
                outline.name
            ),
            fields: names
                .into_iter()
                .map(|name| (name, wrench.clone()))
                .collect(),
        };
        let method = site.method(self.0.as_ref(), |writer, held| {
            let parts = held.iter();
            let parts = parts.flat_map(|(_, [force, moment])| shapes.wrench_part(force, moment));
            let parts: Vec<Id> = parts.collect();
            Method::write(writer, &parts, |values| {
                by_name.filled(site, values, |values| shapes.wrench(values))
            })
        });
        let kind = site.own_type("Reactions");
        let methods = [("reactions", &method, &COMMON[..], &kind)];
        let types = quote!(type Reactions = #kind;);
        let addition = Addition::implement(site, "Reactions", [types, quote!()], &methods);
        by_name.beside(site, addition)
    }
}
