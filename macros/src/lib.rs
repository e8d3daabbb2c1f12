//! The proc macro behind `newton_euler::rigid_body!`: a small compiler from the description of a
//! rigid body to its equations of motion. ARCHITECTURE.md has the map; users want `newton-euler`.

#![forbid(unsafe_code)]

mod checks;
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

/// Expands a description after the path of the runtime, as passed by the macro of `newton-euler`.
#[proc_macro]
pub fn rigid_body(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand::expand(input.into()).into()
}

/// Expands a description of a system.
#[proc_macro]
pub fn rigid_system(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand::expand_system(input.into()).into()
}
