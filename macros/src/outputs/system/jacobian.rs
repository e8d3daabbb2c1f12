//! `jacobian(arm.tip)`: the velocities of points as functions of the rates of the joints.

use quote::quote;

use crate::emit::code::{COMMON, Method, Site};
use crate::emit::items::{Addition, Field, Record};
use crate::lower::Offer;
use crate::mechanics::{self, derive_jacobians};
use crate::model::System;
use crate::outputs::output::{Basis, Output};
use crate::symbolic::Id;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    is_of_motion: true,
    ..Offer::new("jacobian")
};

/// The Jacobian of each requested point.
#[derive(Default)]
pub struct Jacobian(Option<Vec<mechanics::Jacobian>>);

impl Output<System> for Jacobian {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        self.0 = Some(derive_jacobians(basis.model, basis.work));
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let columns = self.0.iter().flatten().flatten();
        columns.flat_map(|column| column.concat()).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (shapes, outline) = (&site.shapes, site.outline);
        let rows = if shapes.motion.is_planar { 3 } else { 6 };
        let size = [rows, outline.freedoms()];
        let (kind, points) = (shapes.matrix_type(size), outline.points.iter());
        let by_name = Record {
            suffix: "Jacobians",
            doc: format!(
                " Velocities of points of [`{}`] by the rates of its state: rows of the velocity, then of the angular velocity, world axes.",
                outline.name
            ),
            fields: points
                .map(|point| Field::new(point, kind.clone()))
                .collect(),
            has_default: true,
        };
        let method = site.method(self.0.as_ref(), |writer, points| {
            let columns = points.iter().flatten();
            let entries = columns.flat_map(|[linear, angular]| {
                [shapes.vector_part(linear), shapes.moment_part(angular)].concat()
            });
            let entries: Vec<Id> = entries.collect();
            Method::write(writer, &entries, |values| {
                by_name.filled(outline, values, |_, values| shapes.matrix(size, values))
            })
        });
        let kind = site.own_type("Jacobians");
        let methods = [("jacobian", &method, &COMMON[..], &kind)];
        let types = quote!(type Jacobians = #kind;);
        let addition = Addition::implement(site, "Jacobian", [types, quote!()], &methods);
        addition.with(outline, &by_name)
    }
}
