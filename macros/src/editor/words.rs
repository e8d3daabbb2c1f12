//! Every word of a description and its place, even where the description cannot be parsed.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

/// A word and its place; `body` is the index of the body of a system in whose braces it stands.
#[derive(Clone)]
pub struct Word {
    pub ident: Ident,
    pub place: Place,
    pub body: Option<usize>,
}

/// The place of a word, which decides what it can be.
#[derive(Clone)]
pub enum Place {
    Key,
    /// The name that an entry of this list defines.
    Entry(String),
    /// The name of the state that a rate belongs to.
    Rate,
    Motion,
    Joint,
    Output,
    Unit,
    /// A name in an expression, not after a dot.
    Name,
    /// A name after a dot, with what precedes the dot if that is a name.
    Member(Option<Ident>),
}

/// Lists whose names can be used in expressions, and what each name stands for.
const NAMED: [(&str, &str); 11] = [
    ("params", "Param"),
    ("inputs", "Input"),
    ("states", "OwnState"),
    ("constants", "Constant"),
    ("functions", "Function"),
    ("points", "Point"),
    ("locals", "Local"),
    ("bodies", "BodyOfSystem"),
    ("joints", "Jointed"),
    ("reactions", "Reaction"),
    ("constraints", "Constraint"),
];

impl Word {
    /// Whether it is the name of an entry of this list.
    pub fn defines(&self, list: &str) -> bool {
        matches!(&self.place, Place::Entry(own) if own == list)
    }

    /// What it stands for in expressions, if it defines a name for them.
    pub fn kind(&self) -> Option<&'static str> {
        let kinds = NAMED.iter().find(|(list, _)| self.defines(list));
        kinds.map(|(_, kind)| *kind)
    }

    /// Whether it is the name of an entry that no expression uses.
    pub fn is_mere_entry(&self) -> bool {
        matches!(self.place, Place::Entry(_)) && self.kind().is_none()
    }
}

/// The words between the braces of a description.
pub fn words(tokens: TokenStream) -> Vec<Word> {
    let mut found = Found::default();
    found.keys(tokens, DEPTH);
    found.words
}

/// Brackets nested deeper than this are not read.
const DEPTH: usize = 64;

/// Words of expressions that are not names.
const NO_NAMES: [&str; 5] = ["_", "if", "else", "true", "false"];

#[derive(Default)]
struct Found {
    words: Vec<Word>,
    /// The index of the body whose braces are read, and the number of bodies so far.
    body: Option<usize>,
    bodies: usize,
}

impl Found {
    fn add(&mut self, ident: &Ident, place: Place) {
        let word = ident.to_string();
        if !NO_NAMES.contains(&word.as_str()) && !word.starts_with("r#") {
            self.words.push(Word {
                ident: ident.clone(),
                place,
                body: self.body,
            });
        }
    }

    fn keys(&mut self, tokens: TokenStream, depth: usize) {
        for entry in entries(tokens) {
            let mut rest = entry.as_slice();
            // a key that is being written comes right before the next key
            while let [TokenTree::Ident(key), after @ ..] = rest {
                self.add(key, Place::Key);
                if let [colon, value @ ..] = after
                    && is_punct(colon, ':')
                {
                    self.value(&key.to_string(), value, depth);
                    break;
                }
                rest = after;
            }
        }
    }

    /// The value of a key.
    fn value(&mut self, key: &str, value: &[TokenTree], depth: usize) {
        match value {
            [TokenTree::Ident(word), rest @ ..] if key == "motion" => {
                self.add(word, Place::Motion);
                self.expression(rest, depth);
            }
            [TokenTree::Group(list)] if list.delimiter() == Delimiter::Bracket => {
                for entry in entries(list.stream()) {
                    self.entry(key, &entry, depth);
                }
            }
            _ => self.expression(value, depth),
        }
    }

    fn entry(&mut self, list: &str, entry: &[TokenTree], depth: usize) {
        let [TokenTree::Ident(name), rest @ ..] = entry else {
            return self.expression(entry, depth);
        };
        match rest {
            _ if list == "outputs" => {
                self.add(name, Place::Output);
                self.expression(rest, depth);
            }
            _ if list == "rates" => {
                self.add(name, Place::Rate);
                self.expression(rest, depth);
            }
            [TokenTree::Group(braces), ..] if list == "bodies" => {
                self.add(name, Place::Entry(list.to_owned()));
                let outside = self.body.replace(self.bodies);
                self.keys(braces.stream(), depth.saturating_sub(1));
                self.body = outside;
                self.bodies += 1;
            }
            [equals, TokenTree::Ident(kind), rest @ ..]
                if list == "joints" && is_punct(equals, '=') =>
            {
                self.add(name, Place::Entry(list.to_owned()));
                self.add(kind, Place::Joint);
                self.expression(rest, depth);
            }
            // the names of arguments are known only in the function, and a path is a path of Rust
            [TokenTree::Group(_), equals, rest @ ..]
                if list == "functions" && is_punct(equals, '=') =>
            {
                self.add(name, Place::Entry(list.to_owned()));
                self.units(rest);
            }
            [equals, rest @ ..] if list == "constants" && is_punct(equals, '=') => {
                self.add(name, Place::Entry(list.to_owned()));
                self.units(rest);
            }
            _ => {
                self.add(name, Place::Entry(list.to_owned()));
                // start after the name: the group in `name[unit]` is a unit only if it follows a
                // word
                self.after(entry, 1, depth);
            }
        }
    }

    fn units(&mut self, tokens: &[TokenTree]) {
        for token in tokens {
            if let TokenTree::Group(group) = token
                && group.delimiter() == Delimiter::Bracket
            {
                self.unit(group);
            }
        }
    }

    fn unit(&mut self, group: &Group) {
        for token in group.stream() {
            if let TokenTree::Ident(unit) = token {
                self.add(&unit, Place::Unit);
            }
        }
    }

    fn expression(&mut self, tokens: &[TokenTree], depth: usize) {
        self.after(tokens, 0, depth);
    }

    /// The words of an expression, starting with the token at `first`.
    fn after(&mut self, tokens: &[TokenTree], first: usize, depth: usize) {
        for (number, token) in tokens.iter().enumerate().skip(first) {
            let before = number.checked_sub(1).map(|before| &tokens[before]);
            let after = tokens.get(number + 1);
            match token {
                TokenTree::Ident(word) => self.word(word, &tokens[..number], after),
                TokenTree::Group(group) => {
                    let is_unit = group.delimiter() == Delimiter::Bracket
                        && before.is_some_and(|token| !matches!(token, TokenTree::Punct(_)));
                    let Some(depth) = depth.checked_sub(1) else {
                        continue;
                    };
                    if is_unit {
                        self.unit(group);
                    } else {
                        for part in entries(group.stream()) {
                            self.expression(&part, depth);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    fn word(&mut self, word: &Ident, before: &[TokenTree], after: Option<&TokenTree>) {
        // it is part of a path of Rust, or a field of `tensor { xx: .. }`
        if after.is_some_and(|token| is_punct(token, ':')) {
            return;
        }
        match before {
            [.., colon] if is_punct(colon, ':') => {
                let is_path = before.len() > 1 && is_punct(&before[before.len() - 2], ':');
                if !is_path {
                    self.add(word, Place::Name);
                }
            }
            [others @ .., TokenTree::Ident(of), dot] if is_punct(dot, '.') => {
                let is_name = !others.last().is_some_and(|token| is_punct(token, '.'));
                self.add(word, Place::Member(is_name.then(|| of.clone())));
            }
            [.., dot] if is_punct(dot, '.') => self.add(word, Place::Member(None)),
            _ => self.add(word, Place::Name),
        }
    }
}

/// The tokens between the commas.
fn entries(tokens: TokenStream) -> Vec<Vec<TokenTree>> {
    let mut all = vec![Vec::new()];
    for token in tokens {
        if is_punct(&token, ',') {
            all.push(Vec::new());
        } else if let Some(entry) = all.last_mut() {
            entry.push(token);
        }
    }
    all
}

fn is_punct(token: &TokenTree, sign: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign)
}
