//! The structure of a body, as the constant of a trait that every body has.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::emit::code::{Site, allow_constants, number_literal};
use crate::emit::items::Addition;
use crate::mechanics::{Dependence, QUANTITIES, Structure, Symmetry};
use crate::model::{Model, Outline};

use crate::outputs::output::{Basis, Output, Place};

#[derive(Default)]
pub struct Structured(Option<Structure>);

impl Output<Model> for Structured {
    fn place(&self, _: &Outline) -> Option<Place> {
        Some(Place::Last)
    }

    fn derive(&mut self, basis: &mut Basis<'_, Model>) -> Option<()> {
        self.0 = Some(basis.equations.structure(basis.model, basis.work).clone());
        Some(())
    }

    /// `impl Structured for Body { const STRUCTURE: Structure = Structure { .. }; }`, with the
    /// claims that hold.
    fn emit(&self, site: &Site<'_>) -> Addition {
        let private = &site.shapes.private;
        let known = self.0.as_ref().map(|structure| whole(structure, private));
        let value = known.unwrap_or_else(|| quote!(#private::Structure::GENERAL));
        let constants = allow_constants(&value);
        let constant = quote!(#constants const STRUCTURE: #private::Structure = #value;);
        Addition::implement(site, "Structured", [constant, quote!()], &[])
    }
}

fn whole(structure: &Structure, private: &TokenStream) -> TokenStream {
    let linear = dependence(&structure.linear, private);
    let angular = dependence(&structure.angular, private);
    let [x, y, z] = structure.planes;
    let claims = [
        (structure.is_force_free, quote!(is_force_free: true)),
        (structure.is_torque_free, quote!(is_torque_free: true)),
        (structure.keeps_spin, quote!(keeps_spin: true)),
        (x || y || z, quote!(planes: [#x, #y, #z])),
    ];
    let rest = claims.iter().any(|(holds, _)| !holds);
    let rest = rest.then(|| quote!(..#private::Structure::GENERAL));
    let claims = claims
        .into_iter()
        .filter(|(holds, _)| *holds)
        .map(|(_, claim)| claim);
    quote!(#private::Structure { linear: #linear, angular: #angular, #(#claims,)* #rest })
}

/// `Dependence { attitude: true, ..Dependence::NOTHING }`
fn dependence(dependence: &Dependence, private: &TokenStream) -> TokenStream {
    let read = QUANTITIES.iter().zip(dependence.reads);
    let read = read.filter(|(_, is_read)| *is_read).map(|(name, _)| {
        let name = format_ident!("{name}");
        quote!(#name: true)
    });
    let symmetries = [("world", dependence.world), ("body", dependence.body)];
    let symmetries = symmetries
        .into_iter()
        .filter(|(_, symmetry)| *symmetry != Symmetry::Every)
        .map(|(name, symmetry)| {
            let name = format_ident!("{name}");
            let symmetry = if let Symmetry::About(direction) = symmetry {
                let direction = direction.map(number_literal);
                quote!(About([#(#direction),*]))
            } else {
                quote!(None)
            };
            quote!(#name: #private::Symmetry::#symmetry)
        });
    let fields: Vec<TokenStream> = read.chain(symmetries).collect();
    if fields.is_empty() {
        return quote!(#private::Dependence::NOTHING);
    }
    let all = QUANTITIES.len() + 2;
    let rest = (fields.len() < all).then(|| quote!(..#private::Dependence::NOTHING));
    quote!(#private::Dependence { #(#fields,)* #rest })
}
