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
    let part = |(kind, solved): (LoadKind, &Components)| match kind {
        LoadKind::Force => shapes.vector_part(solved).to_vec(),
        LoadKind::Moment => shapes.moment_part(solved).to_vec(),
    };
    let kinds = open.iter().map(|(_, kind)| *kind);
    let outputs: Vec<Id> = kinds.zip(solved).flat_map(part).collect();
    let name = format_ident!("{}{suffix}", writer.outline.name);
    Method::write(writer, &outputs, |values| {
        let fields = open.iter().map(|(field, kind)| {
            let value = match kind {
                LoadKind::Force => shapes.vector(values),
                LoadKind::Moment => shapes.moment(values),
            };
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
