//! Names in a file, turned into names in a description.

use std::collections::HashSet;

use proc_macro2::{Ident, Span};

use crate::syntax::words::{BUILT_IN, is_keyword};

/// The name of the point of each link that is its origin in the file.
pub const ORIGIN: &str = "origin";

/// The names that are already in use.
#[derive(Default)]
pub struct Names {
    taken: HashSet<String>,
    /// Names that differ from those in the file.
    pub changed: Vec<String>,
}

/// Why a name cannot be used.
pub enum Refused {
    /// It has neither letters nor digits.
    Empty,
    /// Another name in the file becomes the same word.
    Taken(String),
}

impl Names {
    /// The name of a link.
    pub fn link(&mut self, name: &str, span: Span) -> Result<Ident, Refused> {
        let word = word(name).ok_or(Refused::Empty)?;
        self.take(name, word, span)
    }

    /// The name of a joint, which must differ from those of links.
    pub fn joint(&mut self, name: &str, links: &[&Ident], span: Span) -> Result<Ident, Refused> {
        let mut word = word(name).ok_or(Refused::Empty)?;
        if links.iter().any(|link| **link == word.as_str()) {
            word = extended(&word, "joint");
        }
        self.take(name, word, span)
    }

    /// A name for something other than links and joints, with a suffix if the word is already in
    /// use.
    pub fn fresh(&mut self, name: &str, suffix: &str, span: Span) -> Ident {
        let mut word = word(name).unwrap_or(suffix.to_owned());
        while !self.taken.insert(word.clone()) {
            word = extended(&word, suffix);
        }
        Ident::new(&word, span)
    }

    fn take(&mut self, name: &str, word: String, span: Span) -> Result<Ident, Refused> {
        if !self.taken.insert(word.clone()) {
            return Err(Refused::Taken(word));
        }
        if word != name {
            self.changed.push(format!("`{name}` is `{word}`"));
        }
        Ok(Ident::new(&word, span))
    }
}

/// A word with a suffix, with one underscore between.
pub fn extended(word: &str, suffix: &str) -> String {
    format!("{}_{suffix}", word.trim_end_matches('_'))
}

/// `left-arm.1` as `left_arm_1`. Words of Rust and of this language get an underscore at the end.
pub fn word(name: &str) -> Option<String> {
    let letter = |letter: char| {
        if letter.is_ascii_alphanumeric() {
            letter
        } else {
            '_'
        }
    };
    let mut word: String = name.trim().chars().map(letter).collect();
    if word.bytes().all(|byte| byte == b'_') {
        return None;
    }
    if word.starts_with(|first: char| first.is_ascii_digit()) {
        word.insert(0, '_');
    }
    if is_keyword(&word) || BUILT_IN.contains(&word.as_str()) || word == ORIGIN {
        word.push('_');
    }
    Some(word)
}
