//! Rust items of the user. Each is wrapped in a function of the body, so that names resolve at the
//! description, and type errors are reported once.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::emit::code::{Scalar, given};
use crate::model::{Outline, Workspace};

/// `impl Body { fn given_lift(alpha: f64) -> f64 { curves::lift(alpha) } }`
pub fn emit_foreign(outline: &Outline, work: &Workspace) -> TokenStream {
    if !outline.is_foreign() {
        return TokenStream::new();
    }
    let scalar = Scalar::of(outline);
    let (name, kind) = (&outline.name, scalar.kind());
    let (declared, applied) = (scalar.declared(), scalar.applied());
    let constants = work.constants.iter().map(|constant| {
        let (name, value) = (given(&constant.name.to_string()), &constant.value);
        quote!(fn #name() -> f64 { #value })
    });
    let functions = work.functions.iter().flat_map(|function| {
        let kind = &kind;
        let names: Vec<Ident> = function
            .arguments
            .iter()
            .map(|(name, ..)| hidden(name))
            .collect();
        function.given().map(move |(word, path)| {
            let name = given(&word);
            quote!(fn #name(#(#names: #kind),*) -> #kind { #path(#(#names),*) })
        })
    });
    quote! {
        #[allow(dead_code, non_snake_case, clippy::inline_always)]
        impl #declared #name #applied { #(#[inline(always)] #constants)* #(#[inline(always)] #functions)* }
    }
}

/// The name of an argument, which the path of a function cannot refer to.
fn hidden(name: &Ident) -> Ident {
    Ident::new(
        &name.to_string(),
        Span::mixed_site().located_at(name.span()),
    )
}
