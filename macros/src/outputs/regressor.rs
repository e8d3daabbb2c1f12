//! `regressor`: how the loads of a motion depend on the inertial parameters, a matrix for each
//! body.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::code::{Method, Site, Source, Told, Writer};
use crate::emit::items::Addition;
use crate::lower::{Offer, REGRESSOR};
use crate::mechanics::{self, inertial_parameters};
use crate::model::Outline;
use crate::symbolic::Id;

use super::by_name::PerBody;
use super::output::{Basis, Output};
use super::subject::Subject;

const OFFER: Offer = Offer {
    is_of_motion: true,
    ..Offer::new(REGRESSOR)
};

/// The regressor of each body, in the order of the description.
#[derive(Default)]
pub struct Regressor(Option<Vec<mechanics::Regressor>>);

impl<S: Subject> Output<S> for Regressor {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        let model = basis.model;
        self.0 = Some(model.regressors(basis.outline, basis.work, basis.equations));
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let bodies = self.0.iter().flatten();
        bodies.flat_map(mechanics::Regressor::roots).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let names = inertial_parameters(site.outline.motion);
        let (matrices, regressor) = self.matrices(
            site,
            Told::State,
            (
                "Regressor",
                "The loads of the motion by the inertial parameters of each body",
            ),
            [rows(site.outline), names.len()],
            |body| body.columns.concat(),
        );
        let (columns, parameters) = self.matrices(
            site,
            Told::Nothing,
            (
                "InertialParameters",
                "Mass, first moment and inertia of each body",
            ),
            [names.len(), 1],
            |body| body.parameters.clone(),
        );
        let motion = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Input,
        ];
        let [matrix, column] = [&matrices, &columns].map(|each| each.kind(site));
        let methods = [
            ("regressor", &regressor, &motion[..], &matrix),
            ("inertial_parameters", &parameters, &[], &column),
        ];
        let types = quote! {
            type Regressor = #matrix;
            type Parameters = #column;
            const PARAMETERS: &'static [&'static str] = &[#(#names),*];
        };
        let addition = Addition::implement(site, "Regressor", [types, quote!()], &methods);
        columns.beside(site, matrices.beside(site, addition))
    }
}

impl Regressor {
    /// A matrix for each body, and the method that fills them, column by column.
    fn matrices(
        &self,
        site: &Site<'_>,
        told: Told,
        (suffix, doc): (&'static str, &str),
        size: [usize; 2],
        entries: impl Fn(&mechanics::Regressor) -> Vec<Id>,
    ) -> (PerBody, Method) {
        let shapes = &site.shapes;
        let doc = format!(" {doc} of [`{}`], SI units.", site.outline.name);
        let kind = |_: usize| -> TokenStream { shapes.matrix_type(size) };
        let each = PerBody::new(site, (suffix, &doc), kind, false);
        let method = site.method(self.0.as_ref(), |writer, bodies| {
            let all: Vec<Id> = bodies.iter().flat_map(entries).collect();
            let writer = Writer {
                told,
                ..writer.clone()
            };
            Method::write(&writer, &all, |values| {
                each.filled(site, values, |_, values| shapes.matrix(size, values))
            })
        });
        (each, method)
    }
}

/// The number of balances along the free directions of a body, or of all joints of a system.
fn rows(outline: &Outline) -> usize {
    if outline.is_system {
        return outline.freedoms();
    }
    let motion = outline.motion;
    motion.linear_axes().len() + motion.angular_axes().len()
}
