//! Brackets of the wrong shape behind a word, such as `world[0, 0, 1]` or `tensor { xx = 1, .. }`.
//! They are reported, and read as those that were meant.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, TokenStream, TokenTree};

use crate::errors::{Errors, silently};
use crate::units::is_unit;

use super::bare_unit::is_unit_word;
use super::motion::{ROD, SUPPORTS};
use super::tokens::{after_sign, has_comma, is_punct};
use super::unit::UnitExpression;
use super::words::is_keyword;

/// Words that are followed by braces and named entries.
const RECORDS: [&str; 2] = ["tensor", "products"];
/// Words whose arguments are mistaken for a unit if there is only one.
const CALLED: [&str; 4] = ["world", "body", "moment", "at"];

/// The group as it should be written behind the token `before`.
pub fn meant(group: &Group, before: Option<&TokenTree>, errors: &mut Errors) -> Group {
    let word = match before {
        Some(TokenTree::Ident(word)) if !is_keyword(&word.to_string()) => word,
        _ => return group.clone(),
    };
    let written = group.delimiter();
    let named = names_entries(group.stream());
    let entries = format!(
        "entries stand in braces, with colons: write `{word} {{ xx: .., yy: .., zz: .. }}`"
    );
    let arguments = if named {
        format!("arguments stand in parentheses and have no names: write `{word}(..)`")
    } else {
        format!("arguments stand in parentheses: write `{word}(..)`")
    };
    let (delimiter, message) = match written {
        _ if RECORDS.iter().any(|record| word == record) => match written {
            _ if named && (written != Delimiter::Brace || has_equals(group.stream())) => {
                (Delimiter::Brace, entries)
            }
            // entries without names are reported where the inertia is read
            _ if begins_with_number(group) => (Delimiter::Parenthesis, String::new()),
            _ => return group.clone(),
        },
        Delimiter::Bracket if is_called(word) || has_comma(group) && !begins_with_unit(group) => {
            (Delimiter::Parenthesis, arguments)
        }
        Delimiter::Brace if has_comma(group) || named => (Delimiter::Parenthesis, arguments),
        _ => return group.clone(),
    };
    if !message.is_empty() {
        errors.push(group.span_open(), message);
    }
    let inner = match delimiter {
        Delimiter::Brace => with_colons(group.stream()),
        _ => without_names(group.stream()),
    };
    let mut meant = Group::new(delimiter, inner);
    meant.set_span(group.span());
    meant
}

/// Reports parentheses behind a number, or behind other ones if they hold a unit:
/// `9.81(m / s ^ 2)`. They can be left out.
pub fn behind_number(group: &Group, before: Option<&TokenTree>, errors: &mut Errors) -> bool {
    let is_parentheses = |group: &Group| group.delimiter() == Delimiter::Parenthesis;
    let number = match before {
        _ if !is_parentheses(group) => return false,
        Some(TokenTree::Literal(number)) => number.to_string(),
        Some(TokenTree::Group(before)) if is_parentheses(before) => "(..)".to_owned(),
        _ => return false,
    };
    let message = match written_unit(group) {
        Some(unit) => format!("a unit stands in square brackets: write `{number}[{unit}]`"),
        None if matches!(before, Some(TokenTree::Group(_))) => return false,
        None => format!("a product is written with `*`: write `{number} * (..)`"),
    };
    errors.push(group.span_open(), message);
    true
}

/// The unit in a group, as it should be written.
pub fn written_unit(group: &Group) -> Option<String> {
    let unit = silently(|errors| UnitExpression::parse(group, errors))?;
    let mut words = unit.factors.iter().map(|(word, _)| word.to_string());
    words
        .all(|word| is_unit(&word))
        .then(|| group.stream().to_string())
}

fn is_called(word: &Ident) -> bool {
    let mut all = CALLED.iter().chain(&SUPPORTS).chain([&ROD]);
    all.any(|called| word == called)
}

fn begins_with_number(group: &Group) -> bool {
    let first = group.stream().into_iter().next();
    matches!(first, Some(TokenTree::Literal(_)))
}

fn begins_with_unit(group: &Group) -> bool {
    let first = group.stream().into_iter().next();
    matches!(first, Some(TokenTree::Ident(word)) if is_unit_word(&word))
}

/// The sign behind the name of an entry that begins with `name:` or `name =`.
fn sign_of_name(entry: &[TokenTree]) -> Option<&Punct> {
    let [TokenTree::Ident(_), rest @ ..] = entry else {
        return None;
    };
    let found = after_sign(rest, ':').or_else(|| after_sign(rest, '='));
    found.map(|(sign, _)| sign)
}

/// The tokens between commas, each part with the comma behind it.
fn entries(tokens: TokenStream) -> Vec<Vec<TokenTree>> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let parts = tokens.split_inclusive(|token| is_punct(token, ','));
    parts.map(<[TokenTree]>::to_vec).collect()
}

fn names_entries(tokens: TokenStream) -> bool {
    let all = entries(tokens);
    !all.is_empty() && all.iter().all(|entry| sign_of_name(entry).is_some())
}

fn has_equals(tokens: TokenStream) -> bool {
    let all = entries(tokens);
    let mut signs = all.iter().filter_map(|entry| sign_of_name(entry));
    signs.any(|sign| sign.as_char() == '=')
}

fn with_colons(tokens: TokenStream) -> TokenStream {
    let entries = entries(tokens).into_iter();
    let written = entries.flat_map(|mut entry| {
        if let Some(sign) = sign_of_name(&entry) {
            let mut colon = Punct::new(':', Spacing::Alone);
            colon.set_span(sign.span());
            entry[1] = TokenTree::Punct(colon);
        }
        entry
    });
    written.collect()
}

fn without_names(tokens: TokenStream) -> TokenStream {
    let entries = entries(tokens).into_iter();
    let values = entries.flat_map(|entry| {
        let skipped = sign_of_name(&entry).map_or(0, |_| 2);
        entry.into_iter().skip(skipped)
    });
    values.collect()
}
