//! `mass_matrix`: the inertias that the accelerations are multiplied by, and what drives them.

use quote::quote;

use crate::emit::code::{COMMON, Method, Site};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics::{Inertias, derive_inertias};
use crate::model::System;
use crate::outputs::output::{Basis, Output};
use crate::symbolic::Id;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    is_of_motion: true,
    ..Offer::new("mass_matrix")
};

#[derive(Default)]
pub struct MassMatrix(Option<Inertias>);

impl Output<System> for MassMatrix {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        let inertias = derive_inertias(basis.model, basis.work, basis.equations);
        self.0 = Some(inertias);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let all = self.0.iter();
        all.flat_map(|all| [all.rows.concat(), all.driving.clone()].concat())
            .collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let shapes = &site.shapes;
        let count = site.outline.freedoms();
        let matrix = site.method(self.0.as_ref(), |writer, inertias| {
            Method::write(writer, &inertias.rows.concat(), |values| {
                shapes.matrix([count, count], values)
            })
        });
        let driving = site.method(self.0.as_ref(), |writer, inertias| {
            Method::write(writer, &inertias.driving, |values| {
                shapes.matrix([count, 1], values)
            })
        });
        let [of_matrix, of_driving] =
            [[count, count], [count, 1]].map(|size| shapes.matrix_type(size));
        let methods = [
            ("mass_matrix", &matrix, &COMMON[..], &of_matrix),
            ("generalized_forces", &driving, &COMMON, &of_driving),
        ];
        let types = quote!(type Matrix = #of_matrix; type Forces = #of_driving;);
        Addition::implement(site, "MassMatrix", [types, quote!()], &methods)
    }
}
