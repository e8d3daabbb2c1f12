//! Structs with a field for each joint, body or drive, and the methods that fill them.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::code::{Site, Values};
use crate::emit::items::{Addition, lints};

/// `BodyReactions { elbow: Wrench, .. }`: its name behind that of the system, and its fields.
pub struct ByName {
    pub suffix: &'static str,
    pub doc: String,
    pub fields: Vec<(Ident, TokenStream)>,
    /// Whether its fields have defaults.
    pub has_default: bool,
}

impl ByName {
    /// The struct beside what is implemented with it.
    pub fn beside(&self, site: &Site<'_>, mut addition: Addition) -> Addition {
        addition.implementations.extend(self.declared(site));
        addition.structs.push(self.name(site));
        addition
    }

    fn declared(&self, site: &Site<'_>) -> TokenStream {
        let (name, doc) = (self.name(site), &self.doc);
        let declared = site.shapes.scalar.declared();
        let default = self.has_default.then(|| quote!(Default,));
        let lints = lints(self.fields.iter().map(|(name, _)| name));
        let fields = self.fields.iter().map(|(name, kind)| {
            let doc = format!(" `{name}`");
            quote!(#[doc = #doc] pub #name: #kind)
        });
        quote! {
            #[doc = #doc]
            #lints
            #[derive(Clone, Copy, Debug, #default PartialEq)]
            pub struct #name #declared { #(#fields),* }
        }
    }

    /// The struct, each field, by its number, filled from the next values.
    pub fn filled(
        &self,
        site: &Site<'_>,
        values: &mut Values<'_>,
        fill: impl Fn(usize, &mut Values<'_>) -> TokenStream,
    ) -> TokenStream {
        let name = self.name(site);
        let fields = self.fields.iter().enumerate();
        let fields = fields.map(|(number, (field, _))| {
            let value = fill(number, values);
            quote!(#field: #value)
        });
        quote!(#name { #(#fields),* })
    }

    fn name(&self, site: &Site<'_>) -> Ident {
        quote::format_ident!("{}{}", site.outline.name, self.suffix)
    }
}
