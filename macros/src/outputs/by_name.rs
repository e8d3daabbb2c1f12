//! Structs with a field for each joint or body of a system.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};

use crate::emit::code::{Site, Values};
use crate::emit::items::{Addition, Field, Record};
use crate::model::Outline;

/// A struct with the loads that joints carry, by name.
pub fn reactions_by_name(site: &Site<'_>) -> Record {
    let (shapes, outline) = (&site.shapes, site.outline);
    let (wrench, scalar) = (shapes.wrench_type(), shapes.scalar.kind());
    let wrenches = held(outline).map(|name| Field::new(name, wrench.clone()));
    let kept = outline.kept.iter().filter(|name| outline.is_held(name));
    let scalars = driving_of(outline).map(|(_, name)| name).chain(kept);
    let scalars = scalars.map(|name| Field::new(name, scalar.clone()));
    // colliding names are reported; the stub has one field for them
    let mut seen = HashSet::new();
    let fields = wrenches.chain(scalars);
    let fields = fields.filter(|field| seen.insert(field.name.to_string()));
    Record {
        suffix: "Reactions",
        doc: format!(
            " The loads of the joints of [`{}`] on the bodies that they carry, at the joints' points on these bodies, world axes; drives included.",
            outline.name
        ),
        fields: fields.collect(),
        has_default: true,
    }
}

/// The joints whose reactions are requested.
pub fn held(outline: &Outline) -> impl Iterator<Item = &Ident> {
    outline.holding.iter().filter(|name| outline.is_held(name))
}

/// The drives of joints whose reactions are requested.
pub fn driving_of(outline: &Outline) -> impl Iterator<Item = &(Ident, Ident)> {
    let all = outline.driving.iter();
    all.filter(|(joint, _)| outline.is_held(joint))
}

/// One item for each body. For a system it is a struct with a field for each body, for a single
/// body the item itself.
pub enum PerBody {
    Alone(TokenStream),
    Each(Record),
}

impl PerBody {
    /// `BodyLoads { upper: kind(0), .. }` with documentation, or `kind(0)`.
    pub fn new(
        site: &Site<'_>,
        (suffix, doc): (&'static str, &str),
        kind: impl Fn(usize) -> TokenStream,
        has_default: bool,
    ) -> Self {
        let outline = site.outline;
        if !outline.is_system {
            return Self::Alone(kind(0));
        }
        let bodies = outline.bodies.iter().enumerate();
        Self::Each(Record {
            suffix,
            doc: doc.to_owned(),
            fields: bodies
                .map(|(number, body)| Field::new(body, kind(number)))
                .collect(),
            has_default,
        })
    }

    pub fn kind(&self, site: &Site<'_>) -> TokenStream {
        match self {
            Self::Alone(kind) => kind.clone(),
            Self::Each(record) => site.own_type(record.suffix),
        }
    }

    /// Adds the struct, if there is one, to the implementations that use it.
    pub fn beside(&self, site: &Site<'_>, addition: Addition) -> Addition {
        match self {
            Self::Alone(_) => addition,
            Self::Each(record) => addition.with(site.outline, record),
        }
    }

    /// The items of all bodies, each made for the index of its body from the next values.
    pub fn filled(
        &self,
        site: &Site<'_>,
        values: &mut Values<'_>,
        fill: impl Fn(usize, &mut Values<'_>) -> TokenStream,
    ) -> TokenStream {
        match self {
            Self::Alone(_) => fill(0, values),
            Self::Each(record) => record.filled(site.outline, values, fill),
        }
    }
}
