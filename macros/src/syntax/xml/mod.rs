//! What the file formats have in common: XML elements, their numbers and names, and the resulting
//! description.

pub mod decimal;
pub mod names;
pub mod parse;
pub mod reader;
pub mod written;

use proc_macro2::{Ident, Span, TokenStream};
use roxmltree::Document;

use crate::errors::{Errors, hint};

use super::expression::{Expression, Kind};
use super::{Declaration, Definition, Description, Load};

/// The parts of the written description that affect how a file is read.
#[derive(Clone, Copy)]
pub struct Beside<'a> {
    pub runtime: &'a TokenStream,
    pub bodies: &'a [Description],
    pub joints: &'a [Definition],
    /// Joints of the file that are locked at a value of their coordinate.
    pub locked: &'a [Definition],
    /// Fields that act on all bodies.
    pub fields: &'a [Load],
}

/// The content of a file, as parts of a description.
#[derive(Default)]
pub struct Described {
    pub bodies: Vec<Description>,
    pub joints: Vec<Definition>,
    pub inputs: Vec<Declaration>,
    pub fields: Vec<Load>,
    pub potentials: Vec<Definition>,
    pub drives: Vec<Definition>,
    pub constraints: Vec<Definition>,
    pub told: Told,
}

/// What the documentation says about a file.
#[derive(Default)]
pub struct Told {
    /// Content that is read differently from its text.
    pub read_as: Vec<String>,
    /// Content that is not used.
    pub skipped: Vec<String>,
}

/// The most characters and the most links of a file. An error at these limits is better than
/// minutes of waiting.
const LENGTH: usize = 4_000_000;
pub const LINKS: usize = 1_000;

/// The XML elements of a text.
pub fn document<'t>(
    (name, span): (&str, Span),
    text: &'t str,
    errors: &mut Errors,
) -> Option<Document<'t>> {
    if text.len() > LENGTH {
        return errors.report(span, format!("`{name}` has more than {LENGTH} bytes"));
    }
    match parse::parse(text) {
        Ok(document) => Some(document),
        Err((line, message)) => errors.report(span, format!("{name}:{line}: {message}")),
    }
}

impl Beside<'_> {
    /// The value of the coordinate at which a joint is locked, if it is.
    pub fn locked(self, joint: &Ident) -> Option<Expression> {
        let found = self.locked.iter().find(|locked| locked.name == *joint)?;
        let lost = || Expression {
            kind: Kind::Poisoned,
            extent: found.name.span().into(),
        };
        Some(found.value.clone().unwrap_or_else(lost))
    }

    /// Reports locked names that are not joints, and joints that are locked twice.
    pub fn check_all_locked(self, known: &[String], is_lost: bool, errors: &mut Errors) {
        let mut seen: Vec<&Ident> = Vec::new();
        for name in self.locked.iter().map(|locked| &locked.name) {
            if seen.contains(&name) {
                errors.push(name.span(), format!("`{name}` is locked twice"));
            } else if !known.contains(&name.to_string()) && !is_lost {
                let hint = hint(&name.to_string(), known.iter().map(String::as_str));
                let message = format!("there is no joint `{name}` in the file{hint}");
                errors.push(name.span(), message);
            }
            seen.push(name);
        }
    }
}
