//! An inertia as written, entry by entry, with the places for errors.

use crate::errors::Extent;
use crate::model::{Defaults, Inertia, Mass};
use crate::symbolic::{Id, Number};
use crate::syntax::{Expression, Kind, Prefix};

/// What the reading of an inertia needs.
#[derive(Clone, Copy)]
pub struct Context<'d> {
    pub mass: Mass,
    pub defaults: &'d Defaults,
}

/// An inertia as written, with the places for errors.
pub struct Draft {
    pub inertia: Inertia,
    pub entries: Vec<Entry>,
    pub extent: Extent,
}

/// An entry as written.
pub struct Entry {
    pub row: usize,
    pub column: usize,
    pub extent: Extent,
    /// Its value, before it is moved to G.
    pub value: Id,
    /// Its number, if it is a plain one, for which a correction can be suggested.
    pub literal: Option<Number>,
    pub digits: String,
}

impl Draft {
    /// What was written for an entry of the symmetric matrix.
    pub fn entry(&self, row: usize, column: usize) -> Option<&Entry> {
        self.entries.iter().find(|entry| {
            (entry.row, entry.column) == (row, column) || (entry.column, entry.row) == (row, column)
        })
    }
}

impl Entry {
    pub fn new(row: usize, column: usize, written: &Expression, value: Id) -> Self {
        let digits = literal(written);
        Self {
            row,
            column,
            extent: number_extent(written),
            value,
            literal: digits.as_deref().and_then(parse_literal),
            digits: digits.unwrap_or_default(),
        }
    }
}

/// The digits of a literal, with its sign and without its unit.
fn literal(value: &Expression) -> Option<String> {
    match &value.kind {
        Kind::Number(digits) => Some(digits.clone()),
        Kind::Unit(inner, _) => literal(inner),
        Kind::Prefix(Prefix::Minus, inner) => literal(inner).map(|digits| format!("-{digits}")),
        _ => None,
    }
}

fn parse_literal(digits: &str) -> Option<Number> {
    match digits.strip_prefix('-') {
        Some(digits) => Number::parse(digits).map(|number| -number),
        None => Number::parse(digits),
    }
}

/// The place of the number, without its unit.
fn number_extent(value: &Expression) -> Extent {
    match &value.kind {
        Kind::Unit(inner, _) => number_extent(inner),
        _ => value.extent,
    }
}
