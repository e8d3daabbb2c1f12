//! Names of a file as names of a description.

use std::collections::HashSet;

use proc_macro2::{Ident, Span};

use crate::syntax::words::{BUILT_IN, is_keyword};

/// The point of each link that is the origin of its axes in the file.
pub const ORIGIN: &str = "origin";

/// Names that are given away.
#[derive(Default)]
pub struct Names {
    taken: HashSet<String>,
    /// Names that are not those of the file.
    pub changed: Vec<String>,
}

/// Why a name cannot be used.
pub enum Refused {
    /// It has no letter and no digit.
    Empty,
    /// Another one becomes the same.
    Taken(String),
}

impl Names {
    /// The name of a link.
    pub fn link(&mut self, name: &str, span: Span) -> Result<Ident, Refused> {
        let word = word(name).ok_or(Refused::Empty)?;
        self.take(name, word, span)
    }

    /// The name of a joint, which is none of a link.
    pub fn joint(&mut self, name: &str, links: &[&Ident], span: Span) -> Result<Ident, Refused> {
        let mut word = word(name).ok_or(Refused::Empty)?;
        if links.iter().any(|link| **link == word.as_str()) {
            word.push_str("_joint");
        }
        self.take(name, word, span)
    }

    /// A name of something else than links and joints, with a suffix if it is one of these.
    pub fn fresh(&mut self, name: &str, suffix: &str, span: Span) -> Ident {
        let mut word = word(name).unwrap_or(suffix.to_owned());
        while !self.taken.insert(word.clone()) {
            word = format!("{word}_{suffix}");
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

/// `left-arm.1` as `left_arm_1`; words of Rust and of this language get an underscore behind.
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
