//! Inertia given by its entries: `principal(..)`, `tensor { .. }` and `products { .. }`.

use proc_macro2::Ident;

use crate::errors::{Extent, every};
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, ENTRIES, Inertia};
use crate::syntax::Expression;

use super::draft::{Draft, Entry};
use super::form::FORMS;

impl Lowering<'_> {
    fn refuse_in_plane(&mut self, word: &Ident) -> Option<()> {
        if self.motion.is_planar {
            return self.report(
                word.span(),
                "in the plane an inertia is one number, about the axis through G: write \
                 `inertia: 0.1[kg * m ^ 2]`",
            );
        }
        Some(())
    }

    pub fn principal(
        &mut self,
        word: &Ident,
        parts: &[Expression],
        extent: Extent,
    ) -> Option<Draft> {
        self.refuse_in_plane(word)?;
        if parts.len() != 3 {
            return self.report(
                word.span(),
                format!(
                    "`principal` takes three moments of inertia, and this has {}",
                    parts.len()
                ),
            );
        }
        let moments = parts
            .iter()
            .map(|part| self.scalar(part, Dimension::INERTIA, "a moment of inertia"));
        let moments = every(moments)?;
        let mut rows = [self.work.graph.zeros(); 3];
        for (i, moment) in moments.iter().enumerate() {
            rows[i][i] = *moment;
        }
        let entries = parts
            .iter()
            .zip(moments)
            .enumerate()
            .map(|(i, (part, moment))| Entry::new(i, i, part, moment))
            .collect();
        Some(Draft {
            inertia: Inertia::Spatial(rows),
            entries,
            extent,
        })
    }

    /// `tensor { .. }` has the entries of the tensor, `products { .. }` has products of inertia
    /// `J_xy = +integral of x y dm`. Their off-diagonal entries differ in sign (E3).
    pub fn record(
        &mut self,
        word: &Ident,
        fields: &[(Ident, Expression)],
        extent: Extent,
    ) -> Option<Draft> {
        if word != "tensor" && word != "products" {
            return self.report(
                word.span(),
                format!("`{word}` is no form of inertia: {FORMS}"),
            );
        }
        self.refuse_in_plane(word)?;
        let mut rows = [self.work.graph.zeros(); 3];
        let mut entries = Vec::new();
        let mut complete = true;
        let is_odd = |field: &(Ident, Expression)| entry_meant(&field.0.to_string()).is_some();
        let first_odd = fields.iter().position(is_odd);
        for (index, (name, value)) in fields.iter().enumerate() {
            // letters in front of several names are one mistake
            if first_odd.is_some_and(|first| first < index) && is_odd(&fields[index]) {
                continue;
            }
            let Some((row, column)) = self.place_of_entry(name) else {
                complete = false;
                continue;
            };
            if fields[..index].iter().any(|(other, _)| other == name) {
                self.errors
                    .push(name.span(), format!("`{name}` is given twice"));
                complete = false;
            }
            let Some(entry) = self.scalar(value, Dimension::INERTIA, "an entry of the inertia")
            else {
                complete = false;
                continue;
            };
            let entry = if word == "products" && row != column {
                self.work.graph.negate(entry)
            } else {
                entry
            };
            rows[row][column] = entry;
            rows[column][row] = entry;
            entries.push(Entry::new(row, column, value, entry));
        }
        if !complete {
            return None;
        }
        self.check_diagonals(word, fields)?;
        Some(Draft {
            inertia: Inertia::Spatial(rows),
            entries,
            extent,
        })
    }

    /// Reports missing moments of inertia.
    fn check_diagonals(&mut self, word: &Ident, fields: &[(Ident, Expression)]) -> Option<()> {
        let is_missing = |diagonal: &&str| !fields.iter().any(|(name, _)| name == diagonal);
        let missing = ["xx", "yy", "zz"].into_iter().filter(is_missing);
        let missing: Vec<&str> = missing.collect();
        let (missing, verb) = match missing[..] {
            [] => return Some(()),
            [one] => (one.to_owned(), "is"),
            _ => (missing.join("` and `"), "are"),
        };
        self.report(
            word.span(),
            format!("`{missing}` {verb} missing: all three moments of inertia are needed"),
        )
    }

    fn place_of_entry(&mut self, name: &Ident) -> Option<(usize, usize)> {
        let place = |word: &str| {
            let entry = ENTRIES.iter().find(|(entry, ..)| *entry == word);
            entry.map(|(_, row, column)| (*row, *column))
        };
        let word = name.to_string();
        let reversed: String = word.chars().rev().collect();
        if let Some(place) = place(&word) {
            return Some(place);
        }
        if let Some(meant) = entry_meant(&word) {
            let message = format!("no entry is called `{word}`: write `{meant}`");
            return self.report(name.span(), message);
        }
        let hint = match place(&reversed) {
            Some(_) => format!(": the matrix is symmetric, write `{reversed}`"),
            None => String::new(),
        };
        self.report(
            name.span(),
            format!(
                "no entry is called `{word}`; there are `xx`, `yy`, `zz`, `xy`, `yz` and `zx`{hint}"
            ),
        )
    }
}

/// The entry that a name such as `Ixx` or `J_xy` means.
fn entry_meant(word: &str) -> Option<&'static str> {
    let axes = word.trim_start_matches(['I', 'i', 'J', 'j']);
    let axes = axes.trim_start_matches('_');
    let mut names = ENTRIES.iter().map(|(entry, ..)| *entry);
    names.find(|entry| *entry == axes && axes != word)
}
