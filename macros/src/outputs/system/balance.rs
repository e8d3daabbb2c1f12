//! `balance`: the balances of each body as they are written, given loads, resultants and residuals.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics::{BodyBalance, Resultant, derive_system_balances};
use crate::model::System;
use crate::outputs::loads::{list_loads, load_parts};
use crate::outputs::output::{Basis, Output};
use crate::symbolic::Id;

use super::reactions::reactions_by_name;
use crate::outputs::by_name::ByName;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("balance")
};

/// Of each body, in the order in which they are written.
#[derive(Default)]
pub struct Balance(Option<Vec<BodyBalance>>);

impl Output<System> for Balance {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        let outline = basis.outline;
        if outline.held.is_some() {
            basis.errors.push(
                outline.place(OFFER.word)?,
                "the balance of a body takes the loads of all of its joints: write `reactions` without names",
            );
            return None;
        }
        let (system, work) = (basis.model, &mut *basis.work);
        let all = derive_system_balances(system, work, basis.equations, &outline.holding);
        let mut named: Vec<(&Ident, BodyBalance)> = system
            .bodies
            .iter()
            .map(|body| &body.name)
            .zip(all)
            .collect();
        named.sort_by_key(|(name, _)| outline.bodies.iter().position(|body| body == *name));
        self.0 = Some(named.into_iter().map(|(_, balance)| balance).collect());
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        self.0
            .iter()
            .flatten()
            .flat_map(BodyBalance::roots)
            .collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let fields = |kind: &dyn Fn(usize) -> TokenStream| {
            let bodies = outline.bodies.iter().enumerate();
            bodies
                .map(|(number, body)| (body.clone(), kind(number)))
                .collect()
        };
        let wrench = shapes.wrench_type();
        let wrenches = ByName {
            suffix: "Wrenches",
            doc: format!(
                " Force and moment about G of each body of [`{}`], world axes.",
                outline.name
            ),
            fields: fields(&|_| wrench.clone()),
            has_default: true,
        };
        let resultant = |of: fn(&BodyBalance) -> &Resultant| {
            site.method(self.0.as_ref(), |writer, bodies| {
                let parts = bodies.iter().flat_map(|body| {
                    let Resultant { force, moment } = of(body);
                    shapes.wrench_part(force, moment)
                });
                let parts: Vec<Id> = parts.collect();
                Method::write(writer, &parts, |values| {
                    wrenches.filled(site, values, |_, values| shapes.wrench(values))
                })
            })
        };
        let (applied, residual) = (
            resultant(|balance| &balance.applied),
            resultant(|balance| &balance.residual),
        );
        let load = shapes.load_type();
        let lists = ByName {
            suffix: "Loads",
            doc: format!(" The given loads on each body of [`{}`].", outline.name),
            fields: fields(&|number| {
                let count = self
                    .0
                    .as_ref()
                    .map_or(1, |bodies| bodies[number].loads.len());
                let count = Literal::usize_unsuffixed(count);
                quote!([#load; #count])
            }),
            has_default: false,
        };
        let loads = site.method(self.0.as_ref(), |writer, bodies| {
            let parts = bodies
                .iter()
                .flat_map(|body| load_parts(shapes, &body.loads));
            let parts: Vec<Id> = parts.collect();
            Method::write(writer, &parts, |values| {
                lists.filled(site, values, |body, values| {
                    list_loads(shapes, &bodies[body].loads, values)
                })
            })
        });
        let written = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Reactions,
            Source::Input,
        ];
        let [wrench, list] = [&wrenches, &lists].map(|one| site.own_type(one.suffix));
        let methods = [
            ("applied", &applied, &COMMON[..], &wrench),
            ("residual", &residual, &written, &wrench),
            ("loads", &loads, &COMMON, &list),
        ];
        let reactions = site.reactions_type();
        let types = quote!(type Wrench = #wrench; type Reactions = #reactions; type Loads = #list;);
        let addition = Addition::implement(site, "Balance", [types, quote!()], &methods);
        let addition = lists.beside(site, wrenches.beside(site, addition));
        // the reactions that are handed in, if they are not there yet
        let is_there = outline.rank("reactions").is_some() || !outline.has_reactions();
        if is_there {
            addition
        } else {
            reactions_by_name(site).beside(site, addition)
        }
    }
}
