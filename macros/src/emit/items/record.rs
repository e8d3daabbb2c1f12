//! Structs of named quantities: parameters, inputs, unknowns.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{Scalar, Values, private};
use crate::model::Outline;

/// A struct such as `BodyReactions { elbow: Wrench, .. }`: the suffix to the name of the body, and
/// the fields.
pub struct Record {
    pub suffix: &'static str,
    pub doc: String,
    pub fields: Vec<Field>,
    /// Whether its fields have defaults.
    pub has_default: bool,
}

pub struct Field {
    pub name: Ident,
    pub doc: String,
    pub kind: TokenStream,
    /// Its unit, if it is a declared quantity.
    pub unit: Option<String>,
    /// Its value if it is missing where the struct is read.
    pub default: Option<TokenStream>,
}

impl Field {
    /// A field whose name needs no documentation.
    pub fn new(name: &Ident, kind: TokenStream) -> Self {
        Self {
            name: name.clone(),
            doc: format!(" `{name}`"),
            kind,
            unit: None,
            default: None,
        }
    }
}

impl Record {
    pub fn name(&self, outline: &Outline) -> Ident {
        format_ident!("{}{}", outline.name, self.suffix)
    }

    /// `pub struct BodyReactions { .. }`
    pub fn declared(&self, outline: &Outline) -> TokenStream {
        let (name, doc) = (self.name(outline), &self.doc);
        let scalar = Scalar::of(outline);
        let (generics, kind) = (scalar.declared(), scalar.kind());
        let empty = self.is_marked(outline);
        let empty = empty.then(|| quote!(scalar: ::core::marker::PhantomData<#kind>));
        let default = self.has_default.then(|| quote!(Default,));
        let lints = lints(self.fields.iter().map(|field| &field.name));
        let fields = self.fields.iter();
        let fields = fields.map(
            |Field {
                 name, doc, kind, ..
             }| quote!(#[doc = #doc] pub #name: #kind),
        );
        let written = self.written(outline);
        quote! {
            #[doc = #doc]
            #lints
            #[derive(Clone, Copy, Debug, #default PartialEq)]
            pub struct #name #generics { #(#fields,)* #empty }
            #written
        }
    }

    /// `record! { BodyParams { "m" length: f64 = 2.0, .. } }`, for declared quantities. The runtime's
    /// macro gives the fields names, and serialization if that feature is on. `None` for a struct
    /// without fields.
    fn written(&self, outline: &Outline) -> Option<TokenStream> {
        let (name, private, scalar) = (self.name(outline), private(outline), &outline.scalar);
        let fields = self.fields.iter().map(|field| {
            let (name, kind, unit) = (&field.name, &field.kind, field.unit.as_ref()?);
            let default = field.default.iter();
            Some(quote!(#unit #name: #kind #(= #default)*))
        });
        let fields = fields.collect::<Option<Vec<_>>>()?;
        if fields.is_empty() {
            return None;
        }
        let scalar = scalar.iter();
        Some(quote!(#private::record! { #name #(<#scalar>)* { #(#fields),* } }))
    }

    /// The struct. Each field is made for its index from the next values.
    pub fn filled(
        &self,
        outline: &Outline,
        values: &mut Values<'_>,
        fill: impl Fn(usize, &mut Values<'_>) -> TokenStream,
    ) -> TokenStream {
        let name = self.name(outline);
        let fields = self.fields.iter().enumerate();
        let fields = fields.map(|(number, Field { name, .. })| {
            let value = fill(number, values);
            quote!(#name: #value)
        });
        let empty = self.is_marked(outline);
        let empty = empty.then(|| quote!(scalar: ::core::marker::PhantomData));
        quote!(#name { #(#fields,)* #empty })
    }

    /// Whether its scalar occurs only in a marker.
    fn is_marked(&self, outline: &Outline) -> bool {
        self.fields.is_empty() && Scalar::of(outline).is_generic()
    }
}

/// The lints that the struct allows: users may call inputs `thrust_1`, `thrust_2`, ...
fn lints<'n>(names: impl IntoIterator<Item = &'n Ident>) -> TokenStream {
    let snake_case = snake_case(names).map(|lint| quote!(, #lint));
    quote!(#[allow(clippy::struct_field_names #snake_case)])
}

/// The lint to allow for names such as a parameter `J`, a reaction `R_v` or an input `left__motor`.
pub fn snake_case<'n>(names: impl IntoIterator<Item = &'n Ident>) -> Option<TokenStream> {
    let is_unusual = |name: &Ident| {
        let name = name.to_string();
        name.contains(char::is_uppercase) || name.trim_matches('_').contains("__")
    };
    let unusual = names.into_iter().any(is_unusual);
    unusual.then(|| quote!(non_snake_case))
}
