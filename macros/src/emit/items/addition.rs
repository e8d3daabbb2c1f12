//! What outputs add to a body.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::code::{Method, Site, Source};
use crate::model::Outline;
use crate::symbolic::Cost;

use super::record::Record;
use super::rigid_body::Best;

/// Implementations of traits, and what is said of them.
#[derive(Default)]
pub struct Addition {
    pub implementations: TokenStream,
    /// The structs among these, beside those of every body.
    pub structs: Vec<Ident>,
    /// Operations by method; not of those whose operations are the runtime's.
    pub costs: Vec<(&'static str, Cost)>,
    /// What integrates the body, if this is better than what every body has.
    pub best: Best,
    /// What has to be known before a method is called.
    pub remarks: Vec<&'static str>,
}

/// A method by its name, what it is given, and what it returns.
pub type Signature<'a> = (&'static str, &'a Method, &'a [Source], &'a TokenStream);

impl Addition {
    /// `impl Trait for Body { types, methods, rest }`
    pub fn implement(
        site: &Site<'_>,
        name: &str,
        [types, rest]: [TokenStream; 2],
        methods: &[Signature<'_>],
    ) -> Self {
        let header = site.header(name);
        let declared = methods.iter().map(|(name, method, sources, result)| {
            method.declared(name, &site.arguments(method, sources), result)
        });
        let costs = methods.iter();
        Self {
            implementations: quote!(#header { #types #(#declared)* #rest }),
            costs: costs
                .map(|(name, method, ..)| (*name, method.facts.cost))
                .collect(),
            ..Self::default()
        }
    }

    /// A struct beside what is implemented with it.
    pub fn with(mut self, outline: &Outline, record: &Record) -> Self {
        self.implementations.extend(record.declared(outline));
        self.structs.push(record.name(outline));
        self
    }
}
