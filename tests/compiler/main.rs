//! The compiler from inside: its rooms are mounted here, since a proc-macro crate cannot be linked.
#![allow(missing_docs, dead_code)]
#![allow(
    clippy::needless_pass_by_value,
    reason = "a description is consumed by its expansion"
)]

#[path = "../../macros/src/checks.rs"]
mod checks;
#[path = "../../macros/src/emit/mod.rs"]
mod emit;
#[path = "../../macros/src/errors/mod.rs"]
mod errors;
#[path = "../../macros/src/expand.rs"]
mod expand;
#[path = "../../macros/src/families.rs"]
mod families;
#[path = "../../macros/src/fraction.rs"]
mod fraction;
#[path = "../../macros/src/lower/mod.rs"]
mod lower;
#[path = "../../macros/src/mechanics/mod.rs"]
mod mechanics;
#[path = "../../macros/src/model/mod.rs"]
mod model;
#[path = "../../macros/src/outputs/mod.rs"]
mod outputs;
#[path = "../../macros/src/range.rs"]
mod range;
#[path = "../../macros/src/symbolic/mod.rs"]
mod symbolic;
#[path = "../../macros/src/syntax/mod.rs"]
mod syntax;
#[path = "../../examples/describe/text.rs"]
mod text;

mod calculus;
mod descriptions;
mod documentation;
mod eigen;
mod equations;
mod expansions;
mod files;
mod models;
mod numbers;
mod operations;
mod printed;
mod rooms;
mod trees;
mod words;
mod zeros;

use proc_macro2::TokenStream;
use quote::quote;

/// The expansion of a description, as the macro of the runtime would ask for it.
fn expand_description(description: TokenStream) -> TokenStream {
    expand::expand(quote!((::newton_euler) #description))
}

/// The expansion as `cargo expand` prints it, derives left as they are: without what is for rustdoc alone.
fn pretty(description: TokenStream) -> String {
    let tokens = expand_description(description);
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
