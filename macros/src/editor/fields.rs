//! Words as fields of structs: the structs of the language, the generated items, and structs of the
//! names that the description defines.

use std::collections::HashSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::words::{Place, Word};
use crate::model::{Declared, Outline};

/// A description and the words in it.
pub struct Scene<'a> {
    outline: &'a Outline,
    words: &'a [Word],
    /// The bodies of a system.
    bodies: Vec<&'a Ident>,
}

impl<'a> Scene<'a> {
    pub fn new(outline: &'a Outline, words: &'a [Word]) -> Self {
        let bodies = words.iter().filter(|word| word.defines("bodies"));
        Self {
            outline,
            words,
            bodies: bodies.map(|word| &word.ident).collect(),
        }
    }

    pub fn emit(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let structs = self.structs();
        let (receivers, types): (Vec<_>, Vec<_>) = self.receivers().into_iter().unzip();
        let accesses = self.words.iter().filter_map(|word| self.access(word));
        quote! {
            const _: () = {
                use #runtime::schema;
                #structs
                fn words(#(#receivers: &#types),*) { #(#accesses;)* }
            };
        }
    }

    /// The structs of the names that the description defines. They dereference to those of the
    /// language.
    fn structs(&self) -> TokenStream {
        let [words, members, nothing] = ["Words", "Members", "Nothing"].map(|beneath| {
            let beneath = own(beneath);
            quote!(schema::#beneath)
        });
        let names = self.words.iter().filter(|word| word.body.is_none());
        let names = self.record("Names", &words, names.filter(|word| word.kind().is_some()));
        let entries = self.words.iter().filter(|word| word.is_mere_entry());
        let entries = self.record("Entries", &nothing, entries);
        let bodies = self.bodies.iter().enumerate().map(|(number, body)| {
            let names = || self.names_of(number);
            let of = self.record(&format!("Of_{body}"), &members, names());
            let all = own("Names");
            let inside = record(&format!("In_{body}"), &quote!(#all), names(), |_| false);
            quote!(#of #inside)
        });
        let bodies: TokenStream = bodies.collect();
        quote!(#names #entries #bodies)
    }

    /// The names that a body of a system defines.
    fn names_of(&self, body: usize) -> impl Iterator<Item = &Word> {
        let words = self.words.iter();
        words.filter(move |word| word.body == Some(body) && word.kind().is_some())
    }

    /// A struct whose fields are the names of these words, except for names that generated items
    /// define.
    fn record<'w>(
        &self,
        name: &str,
        beneath: &TokenStream,
        fields: impl Iterator<Item = &'w Word>,
    ) -> TokenStream {
        record(name, beneath, fields, |word| self.item_with(word).is_none())
    }

    /// The local name of the generated struct that has such a field.
    fn item_with(&self, name: &Ident) -> Option<&'static str> {
        let outline = self.outline;
        let is_in = |all: &[Declared]| all.iter().any(|declared| declared.name == *name);
        if is_in(&outline.params) {
            Some("params")
        } else if is_in(&outline.inputs) {
            Some("input")
        } else {
            let is_part = outline.parts().iter().any(|(part, _)| part == name);
            is_part.then_some("state")
        }
    }

    /// A word as a field.
    fn access(&self, word: &Word) -> Option<TokenStream> {
        let name = &word.ident;
        let receiver = match &word.place {
            Place::Key if word.body.is_some() => "keys_of_body".to_owned(),
            Place::Key => "keys".to_owned(),
            Place::Rate => "state".to_owned(),
            Place::Entry(_) => return None,
            Place::Motion => "motions".to_owned(),
            Place::Joint => "kinds".to_owned(),
            Place::Output => "outputs".to_owned(),
            Place::Unit => "units".to_owned(),
            Place::Name => self.receiver_of(word),
            Place::Member(Some(of)) if self.bodies.contains(&of) => format!("of_{of}"),
            Place::Member(_) => "members".to_owned(),
        };
        let receiver = own(&receiver);
        Some(quote!(#receiver.#name))
    }

    /// What a name in an expression is a field of. Names of its own body hide others.
    fn receiver_of(&self, word: &Word) -> String {
        let name = &word.ident;
        let is_name = |other: &Word| other.ident == *name;
        let mut outside = self.words.iter().filter(|word| word.body.is_none());
        match (word.body, self.item_with(name)) {
            (Some(body), _) if self.names_of(body).any(is_name) => {
                format!("of_{}", self.bodies[body])
            }
            (_, Some(item)) => item.to_owned(),
            // the name is unknown so far, because it is being written
            (Some(body), None) if !outside.any(|word| word.kind().is_some() && is_name(word)) => {
                format!("in_{}", self.bodies[body])
            }
            _ => "names".to_owned(),
        }
    }

    /// What words are fields of, and their types.
    fn receivers(&self) -> Vec<(Ident, TokenStream)> {
        let outline = self.outline;
        let (keys, outputs) = if outline.is_system {
            ("System", "SystemOutputs")
        } else {
            ("Body", "Outputs")
        };
        let language = [
            ("keys", keys),
            ("keys_of_body", "Body"),
            ("motions", "Motions"),
            ("kinds", "Joints"),
            ("outputs", outputs),
            ("units", "Units"),
            ("members", "Members"),
        ];
        let language = language.into_iter().map(|(receiver, kind)| {
            let kind = own(kind);
            (own(receiver), quote!(schema::#kind))
        });
        let has_state = outline.has_parts() && !outline.is_still();
        let items = [
            ("params", "Params", !outline.params.is_empty()),
            ("input", "Input", !outline.inputs.is_empty()),
            ("state", "State", has_state),
        ];
        let items = items.into_iter().filter(|(.., exists)| *exists);
        let items = items.map(|(receiver, suffix, _)| {
            let item = format_ident!("{}{suffix}", outline.name);
            (own(receiver), quote!(#item))
        });
        let bodies = self.bodies.iter().flat_map(|body| {
            [("of", "Of"), ("in", "In")].map(|(receiver, kind)| {
                let kind = own(&format!("{kind}_{body}"));
                (own(&format!("{receiver}_{body}")), quote!(#kind))
            })
        });
        let names = own("Names");
        let names = [(own("names"), quote!(#names))];
        let all = language.chain(items).chain(names).chain(bodies);
        all.collect()
    }
}

/// A name that the user's code cannot see.
fn own(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// A struct with these fields, each once, that dereferences to the struct `beneath`.
fn record<'w>(
    name: &str,
    beneath: &TokenStream,
    fields: impl Iterator<Item = &'w Word>,
    defines: impl Fn(&Ident) -> bool,
) -> TokenStream {
    let name = own(name);
    let mut seen = HashSet::new();
    let fields = fields.filter(|word| seen.insert(word.ident.to_string()));
    let fields = fields.map(|word| {
        let kind = own(word.kind().unwrap_or("Entry"));
        let mut field = word.ident.clone();
        if !defines(&field) {
            field.set_span(Span::mixed_site());
        }
        quote!(#field: schema::#kind)
    });
    quote! {
        struct #name { #(#fields),* }
        impl ::core::ops::Deref for #name {
            type Target = #beneath;
            fn deref(&self) -> &#beneath { loop {} }
        }
    }
}
