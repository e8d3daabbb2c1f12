//! A generated method: its computation, its arguments, and its documentation.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::symbolic::Id;

use super::lints::allow_constants;
use super::shapes::Values;
use super::statements::Facts;
use super::writer::{Source, Writer};

/// One generated method.
#[derive(Default)]
pub struct Method {
    pub body: TokenStream,
    pub facts: Facts,
}

impl Method {
    /// The method of an invalid description. It is never run.
    pub fn never() -> Self {
        Self {
            body: quote!(::core::unreachable!("the description has errors")),
            facts: Facts::default(),
        }
    }

    /// Computes `outputs`, and returns the expression that `fill` makes from their values.
    pub fn write(
        writer: &Writer<'_>,
        outputs: &[Id],
        fill: impl FnOnce(&mut Values<'_>) -> TokenStream,
    ) -> Self {
        let code = writer.function(outputs);
        let (statements, value) = (&code.statements, fill(&mut code.outputs.iter()));
        Self {
            body: quote!(#statements #value),
            facts: code.facts,
        }
    }

    /// An argument, with a leading underscore if it is not read.
    pub fn argument(&self, source: Source, name: &str) -> Ident {
        let underscore = if self.facts.reads.contains(&source) {
            ""
        } else {
            "_"
        };
        Ident::new(&format!("{underscore}{name}"), Span::mixed_site())
    }

    /// The lints that the method allows: its notes are doc comments on statements, which rustc does
    /// not use; descriptions may compare for equality and with both ends of a range; and they may
    /// contain numbers that have names elsewhere.
    pub fn lints(&self) -> TokenStream {
        let notes = self
            .facts
            .has_notes
            .then(|| quote!(#[allow(unused_doc_comments)]));
        let equality = self
            .facts
            .has_equality
            .then(|| quote!(#[allow(clippy::float_cmp)]));
        let ranges = self
            .facts
            .has_combined
            .then(|| quote!(#[allow(clippy::manual_range_contains)]));
        let constants = allow_constants(&self.body);
        quote!(#notes #equality #ranges #constants)
    }

    /// `fn name(&self, arguments) -> result { body }`
    pub fn declared(
        &self,
        name: &str,
        arguments: &TokenStream,
        result: &TokenStream,
    ) -> TokenStream {
        let (name, lints, body) = (format_ident!("{name}"), self.lints(), &self.body);
        quote!(#lints fn #name(&self, #arguments) -> #result { #body })
    }
}
