//! Structs with a field for each joint, body or drive, and what there is of each body.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::code::{Site, Values};
use crate::emit::items::{Addition, lints};
use crate::model::Outline;

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

/// What joints carry, by name.
pub fn reactions_by_name(site: &Site<'_>) -> ByName {
    let (shapes, outline) = (&site.shapes, site.outline);
    let (wrench, scalar) = (shapes.wrench_type(), shapes.scalar.kind());
    let wrenches = held(outline).map(|name| (name.clone(), wrench.clone()));
    let kept = outline.kept.iter().filter(|name| outline.is_held(name));
    let scalars = driving_of(outline).map(|(_, name)| name).chain(kept);
    let scalars = scalars.map(|name| (name.clone(), scalar.clone()));
    ByName {
        suffix: "Reactions",
        doc: format!(
            " What the joints of [`{}`] do to the bodies that they carry, at their points there, world axes; drives included.",
            outline.name
        ),
        fields: wrenches.chain(scalars).collect(),
        has_default: true,
    }
}

/// The joints whose reactions are asked for.
pub fn held(outline: &Outline) -> impl Iterator<Item = &Ident> {
    outline.holding.iter().filter(|name| outline.is_held(name))
}

/// The drives of joints whose reactions are asked for.
pub fn driving_of(outline: &Outline) -> impl Iterator<Item = &(Ident, Ident)> {
    let all = outline.driving.iter();
    all.filter(|(joint, _)| outline.is_held(joint))
}

/// What there is of each body: of a system by name, of a body alone that itself.
pub enum PerBody {
    Alone(TokenStream),
    Each(ByName),
}

impl PerBody {
    /// `BodyLoads { upper: kind(0), .. }`, documented, or `kind(0)`.
    pub fn new(
        site: &Site<'_>,
        (suffix, doc): (&'static str, &str),
        kind: impl Fn(usize) -> TokenStream,
        has_default: bool,
    ) -> Self {
        let outline = site.outline;
        if !outline.is_system {
            return Self::Alone(kind(0));
        }
        let bodies = outline.bodies.iter().enumerate();
        Self::Each(ByName {
            suffix,
            doc: doc.to_owned(),
            fields: bodies
                .map(|(number, body)| (body.clone(), kind(number)))
                .collect(),
            has_default,
        })
    }

    pub fn kind(&self, site: &Site<'_>) -> TokenStream {
        match self {
            Self::Alone(kind) => kind.clone(),
            Self::Each(by_name) => site.own_type(by_name.suffix),
        }
    }

    /// The struct beside what is implemented with it, if there is one.
    pub fn beside(&self, site: &Site<'_>, addition: Addition) -> Addition {
        match self {
            Self::Alone(_) => addition,
            Self::Each(by_name) => by_name.beside(site, addition),
        }
    }

    /// The part of each body, by its number, filled from the next values.
    pub fn filled(
        &self,
        site: &Site<'_>,
        values: &mut Values<'_>,
        fill: impl Fn(usize, &mut Values<'_>) -> TokenStream,
    ) -> TokenStream {
        match self {
            Self::Alone(_) => fill(0, values),
            Self::Each(by_name) => by_name.filled(site, values, fill),
        }
    }
}
