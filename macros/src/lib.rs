//! The proc macro behind `newton_euler::rigid_body!`: a small compiler from the description of a
//! rigid body to its equations of motion. ARCHITECTURE.md has the map; users want `newton-euler`.

#![forbid(unsafe_code)]

mod checks;
mod editor;
mod emit;
mod errors;
mod expand;
mod families;
mod fraction;
mod lower;
mod mechanics;
mod model;
mod outputs;
mod range;
mod symbolic;
mod syntax;
mod text;
mod units;

/// Expands a description that follows the path of the runtime, which the macro of `newton-euler`
/// passes.
#[proc_macro]
pub fn rigid_body(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand::expand(input.into()).into()
}

/// Expands a description of a system.
#[proc_macro]
pub fn rigid_system(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand::expand_system(input.into()).into()
}

/// The same as `rigid_body`, preceded by the words of the description as code. The words come first
/// because errors repeat them as text, where completion would not find its place.
#[proc_macro]
pub fn rigid_body_in_editors(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let words = editor::expand_words(input.clone().into());
    [words.into(), rigid_body(input)].into_iter().collect()
}

/// The same as `rigid_system`, preceded by the words of the description as code.
#[proc_macro]
pub fn rigid_system_in_editors(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let words = editor::expand_words_of_system(input.clone().into());
    [words.into(), rigid_system(input)].into_iter().collect()
}
