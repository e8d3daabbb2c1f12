//! `balance`: the balances as they are written, given loads, resultants and residuals.

use proc_macro2::Literal;
use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics::{self, Resultant, derive_balance};
use crate::symbolic::Id;

use crate::model::Model;
use crate::outputs::loads::{list_loads, load_parts};
use crate::outputs::output::{Basis, Output};

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("balance")
};

#[derive(Default)]
pub struct Balance(Option<mechanics::Balance>);

impl Output<Model> for Balance {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, Model>) -> Option<()> {
        self.0 = Some(derive_balance(
            basis.model,
            basis.work,
            &basis.equations.reactions,
        ));
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        self.0.iter().flat_map(mechanics::Balance::roots).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let shapes = &site.shapes;
        let wrench = |of: fn(&mechanics::Balance) -> &Resultant| {
            site.method(self.0.as_ref(), |writer, balance| {
                let Resultant { force, moment } = of(balance);
                let outputs = shapes.wrench_part(force, moment);
                Method::write(writer, &outputs, |values| shapes.wrench(values))
            })
        };
        let (applied, residual) = (
            wrench(|balance| &balance.applied),
            wrench(|balance| &balance.residual),
        );
        let loads = site.method(self.0.as_ref(), |writer, balance| {
            let parts = load_parts(shapes, &balance.loads);
            Method::write(writer, &parts, |values| {
                list_loads(shapes, &balance.loads, values)
            })
        });
        let (wrench, load) = (shapes.wrench_type(), shapes.load_type());
        let count = Literal::usize_unsuffixed(site.outline.loads);
        let (reactions, list) = (site.reactions_type(), quote!([#load; #count]));
        let written = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Reactions,
            Source::Input,
        ];
        let methods = [
            ("applied", &applied, &COMMON[..], &wrench),
            ("residual", &residual, &written, &wrench),
            ("loads", &loads, &COMMON, &list),
        ];
        let types = quote!(type Wrench = #wrench; type Reactions = #reactions; type Loads = #list;);
        Addition::implement(site, "Balance", [types, quote!()], &methods)
    }
}
