//! What is checked of bodies: whether there are any of their mass and inertia.

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::Substance;
use crate::symbolic::Id;

/// Masses and inertias that are checked together, each with the name of its body: masses first, on
/// which inertias may depend.
pub struct Checked<'a> {
    masses: Vec<(&'a str, Id)>,
    inertias: Vec<(&'a str, Vec<Id>)>,
}

impl<'a> Checked<'a> {
    /// Those of which the values are `wanted`.
    pub fn of(bodies: &'a [Substance], wanted: impl Fn(&[Id]) -> bool) -> Self {
        let masses = bodies
            .iter()
            .filter_map(|body| Some((&*body.name, body.mass?)));
        let inertias = bodies
            .iter()
            .map(|body| (&*body.name, body.inertia_entries()));
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

    /// `check_mass("Body", mass)?; check_inertia("Body", [xx, ..])?;` of these values.
    pub fn emit(&self, values: &[TokenStream], private: &TokenStream) -> TokenStream {
        let (masses, mut rest) = values.split_at(self.masses.len());
        let masses = self.masses.iter().zip(masses);
        let masses = masses.map(|((name, _), mass)| quote!(#private::check_mass(#name, #mass)?;));
        let masses: Vec<TokenStream> = masses.collect();
        let inertias = self.inertias.iter().map(|(name, entries)| {
            let (own, others) = rest.split_at(entries.len());
            rest = others;
            match own {
                [moment] => quote!(#private::check_planar_inertia(#name, #moment)?;),
                entries => quote!(#private::check_inertia(#name, [#(#entries),*])?;),
            }
        });
        let inertias: Vec<TokenStream> = inertias.collect();
        quote!(#(#masses)* #(#inertias)*)
    }
}
