//! What outputs add to a body.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::code::{Method, Site, Source};
use crate::model::Outline;
use crate::symbolic::Cost;

use super::record::Record;
use super::rigid_body::Best;

/// Implementations of traits, and their documentation.
#[derive(Default)]
pub struct Addition {
    pub implementations: TokenStream,
    /// The names of the structs in them.
    pub structs: Vec<Ident>,
    /// The operation counts of methods, except for methods of the runtime.
    pub costs: Vec<(&'static str, Cost)>,
    /// The method of integration that it makes possible, if that is better than the general one.
    pub best: Best,
    /// Remarks about the use of a method.
    pub remarks: Vec<&'static str>,
}

/// A method with its name, its arguments, and its result type.
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

    /// Adds a struct.
    pub fn with(mut self, outline: &Outline, record: &Record) -> Self {
        self.implementations.extend(record.declared(outline));
        self.structs.push(record.name(outline));
        self
    }
}
