//! Checks that bodies with the given mass and inertia are possible.

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::Substance;
use crate::symbolic::Id;

/// Masses and inertias that are checked together; in systems, with the names of their bodies.
/// Masses come first, because inertias may depend on them.
pub struct Checked<'a> {
    masses: Vec<(Option<&'a str>, Id)>,
    inertias: Vec<(&'a Substance, Vec<Id>)>,
}

impl<'a> Checked<'a> {
    /// The masses and inertias whose values are `wanted`.
    pub fn of(bodies: &'a [Substance], wanted: impl Fn(&[Id]) -> bool) -> Self {
        let masses = bodies
            .iter()
            .filter_map(|body| Some((body.name.as_deref(), body.mass?)));
        let inertias = bodies.iter().map(|body| (body, body.inertia_entries()));
        Self {
            masses: masses.filter(|(_, mass)| wanted(&[*mass])).collect(),
            inertias: inertias.filter(|(_, entries)| wanted(entries)).collect(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.masses.is_empty() && self.inertias.is_empty()
    }

    /// All masses, and the entries of all inertias.
    pub fn values(&self) -> Vec<Id> {
        let masses = self.masses.iter().map(|(_, mass)| *mass);
        let entries = self.inertias.iter().flat_map(|(_, entries)| entries);
        masses.chain(entries.copied()).collect()
    }

    /// `check_mass(mass)?; member("arm", check_inertia([xx, ..]))?;` for these values.
    pub fn emit(&self, values: &[TokenStream], private: &TokenStream) -> TokenStream {
        let with_name = |name: Option<&str>, check: TokenStream| {
            let named = name.map(|name| quote!(#private::member(#name, #check)?;));
            named.unwrap_or_else(|| quote!(#check?;))
        };
        let (masses, mut rest) = values.split_at(self.masses.len());
        let masses = self.masses.iter().zip(masses);
        let masses =
            masses.map(|((name, _), mass)| with_name(*name, quote!(#private::check_mass(#mass))));
        let masses: Vec<TokenStream> = masses.collect();
        let inertias = self.inertias.iter().map(|(body, entries)| {
            let (own, others) = rest.split_at(entries.len());
            rest = others;
            let check = match (own, body.swings) {
                ([moment], false) => quote!(#private::check_planar_inertia(#moment)),
                ([moment], true) => quote!(#private::check_swinging_planar_inertia(#moment)),
                (entries, false) => quote!(#private::check_inertia([#(#entries),*])),
                (entries, true) => quote!(#private::check_swinging_inertia([#(#entries),*])),
            };
            with_name(body.name.as_deref(), check)
        });
        let inertias: Vec<TokenStream> = inertias.collect();
        quote!(#(#masses)* #(#inertias)*)
    }
}
