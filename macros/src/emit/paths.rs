//! The one place that names the runtime.

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::Outline;

/// The path of what generated code may name.
pub fn private(outline: &Outline) -> TokenStream {
    let runtime = &outline.runtime;
    quote!(#runtime::private)
}
