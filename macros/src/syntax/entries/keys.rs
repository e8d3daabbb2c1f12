//! The keys of a body, and suggestions for unknown ones.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, TokenTree};

use crate::errors::{Errors, Extent, advice_for_key, foreign_key_meant, similar};
use crate::syntax::Description;
use crate::syntax::tokens::{is_punct, start};
use crate::syntax::words::is_keyword;

/// Keys whose value is a list, each with an example entry.
pub const LISTS: [(&str, &str); 18] = [
    ("constants", "area = crate::AREA[m ^ 2]"),
    ("functions", "lift(alpha) = crate::lift[N]"),
    ("params", "arm = 0.2[m]"),
    ("inputs", "thrust[N]"),
    ("states", "speed[rad / s]"),
    ("rates", "speed = (command - speed) / lag"),
    ("points", "tip = (0.1, 0, 0)"),
    ("locals", "total = thrust_1 + thrust_2"),
    ("forces", "push = body(1, 0, 0).at(tip)"),
    ("moments", "drag = body(0, 0, 1)"),
    ("joint_forces", "pull = body(1, 0, 0).at(tip)"),
    ("joint_moments", "motor = body(0, 0, 1)"),
    ("reactions", "support = world(0, 0, 1).at(tip)"),
    ("constraints", "contact = position.in_world().z"),
    ("fields", "weight = mass * world(0, 0, -9.80665[m / s ^ 2])"),
    ("potentials", "spring = 20[N / m] * position.norm_squared()"),
    ("outputs", "energy"),
    ("checks", "light = mass < 3[kg]"),
];
/// Keys that only systems have.
const OF_SYSTEMS: [&str; 7] = [
    "bodies", "joints", "drives", "drawing", "locked", "urdf", "mjcf",
];
/// All other keys.
pub const VALUES: [&str; 5] = ["doc", "motion", "mass", "inertia", "pole"];

/// The key that `word` is, or was probably meant to be.
pub fn key_meant(word: &str) -> Option<&'static str> {
    let known = || LISTS.iter().map(|(key, _)| *key).chain(VALUES);
    known()
        .find(|key| *key == word)
        .or_else(|| similar(word, known()))
}

/// Reports an unknown key, and suggests the one that was probably meant.
pub fn report_unknown(key: &Ident, meant: Option<&str>, errors: &mut Errors) {
    if let Some(advice) = advice_for_key(&key.to_string()).filter(|_| meant.is_none()) {
        errors.push(key.span(), format!("unknown key `{key}`: {advice}"));
        return;
    }
    let elsewhere = || foreign_key_meant(&key.to_string());
    let hint = meant.or_else(elsewhere).map_or_else(
        || "; the documentation of the macro lists all keys".to_owned(),
        |meant| format!("; did you mean `{meant}`?"),
    );
    errors.push(key.span(), format!("unknown key `{key}`{hint}"));
}

/// Whether a key belongs to systems alone.
pub fn is_of_systems(key: &Ident) -> bool {
    OF_SYSTEMS.iter().any(|word| key == word)
}

impl Description {
    /// Whether this is a system that is described as a body, which is reported.
    pub fn is_system(&self) -> bool {
        self.keys.iter().any(is_of_systems)
    }
}

/// Reports a system that is described as a body, once.
pub fn report_of_system(into: &mut Description, key: &Ident, errors: &mut Errors) {
    if !into.is_system() {
        let message = format!("`{key}` belongs to a system of bodies: write `rigid_system!`");
        errors.push(key.span(), message);
    }
    into.keys.push(key.clone());
}

/// The braces behind a word that is no key, with or without a colon, if they hold keys.
pub fn further_braces(rest: &[TokenTree]) -> Option<&Group> {
    let group = match rest {
        [TokenTree::Group(group)] => group,
        [colon, TokenTree::Group(group)] if is_punct(colon, ':') => group,
        _ => return None,
    };
    holds_keys(group).then_some(group)
}

/// Whether a group holds `key: value`.
pub fn holds_keys(group: &Group) -> bool {
    let mut tokens = group.stream().into_iter();
    let first = tokens.next().as_ref().and_then(name_of);
    let is_key = first.is_some_and(|word| key_meant(&word) == Some(&word));
    is_key && tokens.next().is_some_and(|sign| is_punct(&sign, ':'))
}

/// The word that a token is.
pub fn name_of(token: &TokenTree) -> Option<String> {
    match token {
        TokenTree::Ident(name) => Some(name.to_string()),
        _ => None,
    }
}

/// An entry of a list, as it would be written in brackets. In braces, which are reported, it may be
/// `name: value`.
pub fn bracketed_entry(list: &Group, mut entry: Vec<TokenTree>) -> Vec<TokenTree> {
    let is_switch = |word: &TokenTree| matches!(word, TokenTree::Ident(word) if word == "true" || word == "false");
    if let (Delimiter::Brace, [TokenTree::Ident(_), _, switch]) = (list.delimiter(), &entry[..])
        && is_switch(switch)
    {
        entry.truncate(1);
    }
    if let (Delimiter::Brace, [TokenTree::Ident(_), sign, ..]) = (list.delimiter(), &mut entry[..])
        && is_punct(sign, ':')
    {
        let mut equals = Punct::new('=', Spacing::Alone);
        equals.set_span(sign.span());
        *sign = TokenTree::Punct(equals);
    }
    entry
}

/// The first word of an entry, and the tokens after it.
pub fn key_word<'t>(
    entry: &'t [TokenTree],
    errors: &mut Errors,
) -> Option<(&'t Ident, &'t [TokenTree])> {
    match entry {
        [TokenTree::Ident(key), rest @ ..] => {
            let word = key.to_string();
            if !is_keyword(&word) && word != "_" && !word.starts_with("r#") {
                return Some((key, rest));
            }
            let message = match (word.as_str(), rest.first().and_then(name_of)) {
                ("let" | "const" | "static", Some(name)) => {
                    format!("`{word}` is no key: write `locals: [{name} = ..]`")
                }
                ("fn", Some(name)) => format!(
                    "`fn` is no key: write the function outside, and declare it with its units, as in \
                     `functions: [{name}(x[m]) = {name}[N]]`"
                ),
                _ => format!("`{word}` is no key: expected one such as `mass: 1[kg]`"),
            };
            errors.push(key.span(), message);
        }
        [first, second, ..] if is_punct(first, '.') && is_punct(second, '.') => errors.push(
            Extent::from(first.span()).to(second.span().into()),
            "a description is complete in itself: `..` cannot be used",
        ),
        [first, second, ..] if is_punct(first, '<') && is_punct(second, '!') => {
            errors.push(first.span(), "a comment begins with `//`");
        }
        [TokenTree::Literal(digits), ..] if is_group_of_digits(&digits.to_string()) => errors.push(
            digits.span(),
            format!("a number has no commas: write `1{digits}` or `1_{digits}` for `1,{digits}`"),
        ),
        [first, ..] => errors.push(start(first), "expected a key, such as `mass: 1[kg]`"),
        [] => {}
    }
    None
}

/// Whether these may be the thousands of a number that is written with a comma.
fn is_group_of_digits(text: &str) -> bool {
    text.len() == 3 && text.bytes().all(|byte| byte.is_ascii_digit())
}
