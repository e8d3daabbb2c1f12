//! The values of loads with unknown components, once they are solved for.

use proc_macro2::Ident;
use quote::quote;

use crate::emit::code::{Method, Shapes, Writer};
use crate::families::LoadKind;
use crate::model::Outline;
use crate::symbolic::{Components, Id};

use super::record::{Field, Record};

/// `BodyReactions { pin: Vector3, .. }`
pub fn open_reactions(outline: &Outline) -> Record {
    Record {
        suffix: "Reactions",
        doc: format!(
            " The unknown reactions of [`{}`], world axes.",
            outline.name
        ),
        fields: open_fields(outline, &outline.reactions),
        has_default: true,
    }
}

/// `BodyDrives { motor: f64, .. }`
pub fn open_drives(outline: &Outline) -> Record {
    Record {
        suffix: "Drives",
        doc: format!(
            " The unknown drives of [`{}`], in the axes of the description.",
            outline.name
        ),
        fields: open_fields(outline, &outline.drives),
        has_default: true,
    }
}

fn open_fields(outline: &Outline, open: &[(Ident, LoadKind)]) -> Vec<Field> {
    let shapes = Shapes::of(outline);
    let fields = open.iter().map(|(name, kind)| {
        let (kind, unit) = match kind {
            LoadKind::Force => (shapes.vector_type(), "N"),
            LoadKind::Moment => (shapes.moment_type(), "N * m"),
        };
        Field {
            name: name.clone(),
            doc: format!(" `{name}` in {unit}."),
            kind,
            unit: None,
            default: None,
        }
    });
    fields.collect()
}

/// `BodyReactions { pin: .., guide: .. }` for the loads `open`.
pub fn write_open(
    writer: &Writer<'_>,
    record: &Record,
    open: &[(Ident, LoadKind)],
    solved: &[Components],
) -> Method {
    let shapes = &writer.shapes;
    let parts = open.iter().zip(solved);
    let parts = parts.flat_map(|((_, kind), solved)| &solved[shapes.motion.axes_of(*kind)]);
    let outputs: Vec<Id> = parts.copied().collect();
    Method::write(writer, &outputs, |values| {
        let solved = record.filled(writer.outline, values, |number, values| {
            shapes.load(open[number].1, values)
        });
        if writer.is_fallible {
            quote!(::core::result::Result::Ok(#solved))
        } else {
            solved
        }
    })
}
