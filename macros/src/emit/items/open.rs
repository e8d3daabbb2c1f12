//! Loads with unknown components, as they are solved for.

use proc_macro2::Ident;
use quote::{format_ident, quote};

use crate::emit::code::{Method, Writer};
use crate::families::LoadKind;
use crate::symbolic::{Components, Id};

/// `BodyReactions { pin: .., guide: .. }`
pub fn write_open(
    writer: &Writer<'_>,
    suffix: &str,
    open: &[(Ident, LoadKind)],
    solved: &[Components],
) -> Method {
    let shapes = &writer.shapes;
    let parts = open.iter().zip(solved);
    let parts = parts.flat_map(|((_, kind), solved)| &solved[shapes.motion.axes_of(*kind)]);
    let outputs: Vec<Id> = parts.copied().collect();
    let name = format_ident!("{}{suffix}", writer.outline.name);
    Method::write(writer, &outputs, |values| {
        let fields = open.iter().map(|(field, kind)| {
            let value = shapes.load(*kind, values);
            quote!(#field: #value)
        });
        let solved = quote!(#name { #(#fields),* });
        if writer.is_fallible {
            quote!(::core::result::Result::Ok(#solved))
        } else {
            solved
        }
    })
}
