//! Lists of given loads, in the runtime's types.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::code::{Shapes, Values};
use crate::families::Family;
use crate::mechanics::LoadExpressions;
use crate::symbolic::Id;

/// The components of loads, in the order of the list.
pub fn load_parts(shapes: &Shapes, loads: &[LoadExpressions]) -> Vec<Id> {
    let parts = |load: &LoadExpressions| {
        let (force, point, moment) = (
            shapes.vector_part(&load.force),
            shapes.vector_part(&load.point),
            shapes.moment_part(&load.moment),
        );
        [force, point, moment].concat()
    };
    loads.iter().flat_map(parts).collect()
}

/// `[Load { name, family, force, point, moment }, ..]`
pub fn list_loads(
    shapes: &Shapes,
    loads: &[LoadExpressions],
    values: &mut Values<'_>,
) -> TokenStream {
    let (private, kind) = (&shapes.private, shapes.load_type());
    let loads = loads.iter().map(|load| {
        let name = &load.name;
        let family = match load.family {
            Family::Reaction => quote!(Reaction),
            Family::Joint => quote!(Joint),
            Family::External => quote!(External),
            Family::Field => quote!(Field),
        };
        let (force, point, moment) = (
            shapes.vector(values),
            shapes.vector(values),
            shapes.moment(values),
        );
        quote!(#kind { name: #name, family: #private::Family::#family, force: #force, point: #point, moment: #moment })
    });
    let loads: Vec<TokenStream> = loads.collect();
    quote!([#(#loads),*])
}
