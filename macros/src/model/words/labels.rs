//! Words: the meanings of symbols, and the names of expressions.

use std::collections::HashMap;

use crate::symbolic::{Components, Id, ShortMap};

/// Axes, as suffixes of names.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// Names of expressions, for statements and documentation. An expression keeps its first name.
#[derive(Default)]
pub struct Labels {
    names: ShortMap<Id, String>,
    notes: HashMap<&'static str, &'static str>,
    meanings: ShortMap<Id, &'static str>,
    /// The unknowns that guarded reciprocals give.
    unknowns: ShortMap<Id, String>,
    /// Whether nothing gets a name, as in trials.
    is_silent: bool,
}

impl Labels {
    /// Labels for a trial, in which nothing gets a name.
    pub fn silent() -> Self {
        Self {
            is_silent: true,
            ..Self::default()
        }
    }

    /// Empty labels for a part of the work, to be adopted or discarded later.
    pub fn part(&self) -> Self {
        Self {
            is_silent: self.is_silent,
            ..Self::default()
        }
    }

    pub fn name(&mut self, id: Id, name: impl Into<String>) {
        if !self.is_silent {
            self.names.entry(id).or_insert_with(|| name.into());
        }
    }

    /// Names the components `name_x`, `name_y`, `name_z`.
    pub fn vector(&mut self, name: &str, components: Components) {
        if self.is_silent {
            return;
        }
        for (id, axis) in components.into_iter().zip(AXES) {
            self.name(id, format!("{name}_{axis}"));
        }
    }

    /// The same for an angular quantity. In the plane, it is about z and has a single name.
    pub fn vector_or_one(&mut self, name: &str, of: &str, components: Components) {
        let [x, y, z] = components;
        if x == y && x != z {
            self.name(z, format!("{name}_{of}"));
        } else {
            self.vector(&format!("{name}_{of}"), components);
        }
    }

    /// Names the entries `name_xx`, `name_xy`, ...
    pub fn matrix(&mut self, name: &str, rows: &[Components; 3]) {
        if self.is_silent {
            return;
        }
        for (row, first) in rows.iter().zip(AXES) {
            for (id, second) in row.iter().zip(AXES) {
                self.name(*id, format!("{name}_{first}{second}"));
            }
        }
    }

    /// Describes the expressions named `name`, `name_x`, ...
    pub fn describe(&mut self, name: &'static str, note: &'static str) {
        self.notes.entry(name).or_insert(note);
    }

    /// Describes expressions that have names of their own, such as those of each body.
    pub fn explain(&mut self, ids: impl IntoIterator<Item = Id>, meaning: &'static str) {
        if !self.is_silent {
            for id in ids {
                self.meanings.entry(id).or_insert(meaning);
            }
        }
    }

    /// Gives the names and meanings of expressions to their images, which replace them.
    pub fn follow(&mut self, images: &[(Id, Id)]) {
        for (id, image) in images {
            if let Some(name) = self.names.get(id).cloned() {
                self.name(*image, name);
            }
            if let Some(meaning) = self.meanings.get(id).copied() {
                self.explain([*image], meaning);
            }
        }
    }

    /// Adopts the names and descriptions of a part.
    pub fn adopt(&mut self, part: Self) {
        for (id, name) in part.names {
            self.name(id, name);
        }
        for (name, note) in part.notes {
            self.describe(name, note);
        }
        for (id, meaning) in part.meanings {
            self.explain([id], meaning);
        }
    }

    /// The name without the suffix of an axis, and its description.
    pub fn note(&self, name: &str) -> Option<(&'static str, &'static str)> {
        let group = AXES
            .iter()
            .find_map(|axis| name.strip_suffix(axis)?.strip_suffix('_'))
            .unwrap_or(name);
        self.notes
            .get_key_value(group)
            .map(|(group, note)| (*group, *note))
    }

    pub fn meaning(&self, id: Id) -> Option<&'static str> {
        self.meanings.get(&id).copied()
    }

    /// Records the unknown that a division solves for.
    pub fn divide_for(&mut self, reciprocal: Id, unknown: String) {
        self.unknowns.entry(reciprocal).or_insert(unknown);
    }

    /// The unknown that a guarded reciprocal gives.
    pub fn unknown(&self, reciprocal: Id) -> &str {
        self.unknowns.get(&reciprocal).map_or("", String::as_str)
    }

    pub fn get(&self, id: Id) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }
}
