//! `balance`: the balances as written, given loads, resultants and residuals.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics::{self, Resultant};
use crate::symbolic::Id;

use super::by_name::{PerBody, reactions_by_name};
use super::loads::{list_loads, load_parts};
use super::output::{Basis, Output};
use super::subject::Subject;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("balance")
};

/// The balances of each body, in the order in which the bodies are written.
#[derive(Default)]
pub struct Balance(Option<Vec<mechanics::Balance>>);

impl<S: Subject> Output<S> for Balance {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        let outline = basis.outline;
        if outline.held.is_some() {
            return basis.errors.report(
                outline.place(OFFER.word)?,
                "the balance of a body takes the loads of all of its joints: write `reactions` without names",
            );
        }
        let all = basis.model.balances(basis.work, basis.equations, outline);
        self.0 = Some(all);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let all = self.0.iter().flatten();
        all.flat_map(mechanics::Balance::roots).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (wrenches, applied, residual) = self.wrenches(site);
        let (lists, loads) = self.lists(site);
        let written = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Reactions,
            Source::Input,
        ];
        let [wrench, list] = [&wrenches, &lists].map(|each| each.kind(site));
        let methods = [
            ("applied", &applied, &COMMON[..], &wrench),
            ("residual", &residual, &written, &wrench),
            ("loads", &loads, &COMMON, &list),
        ];
        let reactions = site.reactions_type();
        let types = quote!(type Wrench = #wrench; type Reactions = #reactions; type Loads = #list;);
        let addition = Addition::implement(site, "Balance", [types, quote!()], &methods);
        let addition = lists.beside(site, wrenches.beside(site, addition));
        // callers pass in the reactions of joints: add their struct, unless `reactions` does
        let outline = site.outline;
        let is_there = outline.rank("reactions").is_some() || !outline.has_reactions();
        if is_there || !outline.is_system {
            addition
        } else {
            addition.with(outline, &reactions_by_name(site))
        }
    }
}

impl Balance {
    /// The methods for the resultants of each body: those of the given loads, and the residuals.
    fn wrenches(&self, site: &Site<'_>) -> (PerBody, Method, Method) {
        let shapes = &site.shapes;
        let doc = format!(
            " Force and moment about G of each body of [`{}`], world axes.",
            site.outline.name
        );
        let each = PerBody::new(site, ("Wrenches", &doc), |_| shapes.wrench_type(), true);
        let method = |of: fn(&mechanics::Balance) -> &Resultant| {
            site.method(self.0.as_ref(), |writer, bodies| {
                let parts = bodies.iter().flat_map(|body| {
                    let Resultant { force, moment } = of(body);
                    shapes.wrench_part(force, moment)
                });
                let parts: Vec<Id> = parts.collect();
                Method::write(writer, &parts, |values| {
                    each.filled(site, values, |_, values| shapes.wrench(values))
                })
            })
        };
        let (applied, residual) = (method(|one| &one.applied), method(|one| &one.residual));
        (each, applied, residual)
    }

    /// The method for the lists of given loads on each body.
    fn lists(&self, site: &Site<'_>) -> (PerBody, Method) {
        let shapes = &site.shapes;
        let load = shapes.load_type();
        let list = |number: usize| -> TokenStream {
            let derived = self.0.as_ref().map(|bodies| bodies[number].loads.len());
            let count = Literal::usize_unsuffixed(derived.unwrap_or(site.outline.loads));
            quote!([#load; #count])
        };
        let doc = format!(
            " The given loads on each body of [`{}`].",
            site.outline.name
        );
        let each = PerBody::new(site, ("Loads", &doc), list, false);
        let method = site.method(self.0.as_ref(), |writer, bodies| {
            let parts = bodies
                .iter()
                .flat_map(|body| load_parts(shapes, &body.loads));
            let parts: Vec<Id> = parts.collect();
            Method::write(writer, &parts, |values| {
                each.filled(site, values, |body, values| {
                    list_loads(shapes, &bodies[body].loads, values)
                })
            })
        });
        (each, method)
    }
}
