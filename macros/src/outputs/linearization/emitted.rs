//! A struct of the acceleration and of blocks, and the method that fills it.

use quote::{format_ident, quote};

use crate::emit::code::{COMMON, Method, Site};
use crate::emit::items::{Addition, Field, Record};
use crate::mechanics::Linearization;
use crate::symbolic::Id;

use super::matrices::Placed;

/// The names of the trait, its struct and its method, and their documentation.
pub struct Words {
    pub name: &'static str,
    pub method: &'static str,
    pub doc: String,
}

pub fn emitted(
    site: &Site<'_>,
    found: Option<&Linearization>,
    blocks: &[Placed],
    words: Words,
) -> Addition {
    let shapes = &site.shapes;
    let acceleration = Field::new(&format_ident!("acceleration"), shapes.acceleration_type());
    let fields = blocks
        .iter()
        .map(|one| Field::new(&one.name, one.kind(shapes)));
    let by_name = Record {
        suffix: words.name,
        doc: words.doc,
        fields: [acceleration].into_iter().chain(fields).collect(),
        has_default: false,
    };
    let method = site.method(found, |writer, found| {
        let entries = found.blocks.iter().flat_map(|block| &block.entries);
        let roots: Vec<Id> = found.accelerations.iter().chain(entries).copied().collect();
        Method::write(writer, &roots, |values| {
            by_name.filled(site.outline, values, |field, values| match field {
                0 => shapes.acceleration(values),
                field => blocks[field - 1].filled(shapes, values),
            })
        })
    });
    let kind = site.own_type(words.name);
    let methods = [(words.method, &method, &COMMON[..], &kind)];
    let associated = format_ident!("{}", words.name);
    let types = quote!(type #associated = #kind;);
    let addition = Addition::implement(site, words.name, [types, quote!()], &methods);
    addition.with(site.outline, &by_name)
}
