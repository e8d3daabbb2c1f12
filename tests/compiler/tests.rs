//! Tests of the compiler from inside.
#![allow(missing_docs)]
#![allow(
    clippy::needless_pass_by_value,
    reason = "a description is consumed by its expansion"
)]

#[path = "../../examples/describe/src/text.rs"]
mod text;

mod calculus;
mod descriptions;
mod documentation;
mod eigen;
mod equations;
mod expansions;
mod files;
mod fractions_of_a_turn;
mod from_root;
mod identities;
mod jumps;
mod magnitudes;
mod models;
mod numbers;
mod operations;
mod printed;
mod rooms;
mod same_models;
mod symbols;
mod trees;
mod words;
mod zeros;

use proc_macro2::TokenStream;
use quote::quote;

/// The expansion of a description, as the macro of the runtime would ask for it.
fn expand_description(description: TokenStream) -> TokenStream {
    mounted::expand::expand(quote!((::newton_euler) #description))
}

/// The same of a system.
fn expand_system(description: TokenStream) -> TokenStream {
    mounted::expand::expand_system(quote!((::newton_euler) #description))
}

/// The expansion of a body as `cargo expand` prints it.
fn pretty(description: TokenStream) -> String {
    printed(expand_description(description))
}

/// As `cargo expand` prints it, derives left as they are: without what is for rustdoc alone.
fn printed(tokens: TokenStream) -> String {
    let mut file: syn::File = syn::parse2(tokens).expect("an expansion is a list of items");
    file.items.iter_mut().for_each(without_text);
    prettyplease::unparse(&file)
}

fn without_text(item: &mut syn::Item) {
    match item {
        syn::Item::Struct(item) => {
            let is_code = |attribute: &syn::Attribute| !attribute.path().is_ident("cfg_attr");
            item.attrs.retain(is_code);
        }
        syn::Item::Mod(item) => {
            let items = item.content.iter_mut().flat_map(|(_, items)| items);
            items.for_each(without_text);
        }
        _ => {}
    }
}
