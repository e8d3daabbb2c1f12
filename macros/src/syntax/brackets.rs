//! Brackets of the wrong shape behind a word, such as `world[0, 0, 1]` or `tensor { xx = 1, .. }`.
//! They are reported, and read as those that were meant.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, TokenStream, TokenTree};

use crate::errors::{Errors, Extent, silently};
use crate::text::to_text;
use crate::units::is_unit;

use super::bare_unit::is_unit_word;
use super::motion::{ROD, SUPPORTS};
use super::tokens::{after_sign, has_comma, is_punct};
use super::unit::UnitExpression;
use super::words::is_keyword;

/// Words that are followed by braces and named entries.
const RECORDS: [&str; 2] = ["tensor", "products"];
/// Words whose arguments are mistaken for a unit if there is only one.
const CALLED: [&str; 5] = ["world", "body", "moment", "at", "table"];
/// The most letters of arguments that a message repeats.
const ARGUMENTS: usize = 40;

/// The group at `index`, as it should be written behind the word before it.
pub fn meant(group: &Group, tokens: &[TokenTree], index: usize, errors: &mut Errors) -> Group {
    let word = match index.checked_sub(1).map(|before| &tokens[before]) {
        Some(TokenTree::Ident(word)) if !is_keyword(&word.to_string()) => word,
        _ => return group.clone(),
    };
    let is_method = index > 1 && is_punct(&tokens[index - 2], '.');
    // braces behind a word may be a branch
    let is_branch = tokens[..index]
        .iter()
        .any(|token| matches!(token, TokenTree::Ident(word) if word == "if"));
    let written = group.delimiter();
    let named = names_entries(group.stream());
    let is_record = is_record(index.checked_sub(1).map(|before| &tokens[before]));
    let is_call = match written {
        Delimiter::Bracket => {
            is_called(word)
                || has_comma(group) && !begins_with_unit(group)
                || is_method && component_meant(group).is_none() && written_unit(group).is_none()
        }
        Delimiter::Brace => has_comma(group) || named || !is_branch,
        Delimiter::Parenthesis => named,
        Delimiter::None => false,
    };
    let (delimiter, message) = match written {
        _ if is_record && named => match written {
            Delimiter::Brace if !has_equals(group.stream()) => return group.clone(),
            _ => (
                Delimiter::Brace,
                format!(
                    "entries go in braces, with colons: write `{word} {{ xx: .., yy: .., zz: .. }}`"
                ),
            ),
        },
        // entries without names are reported where the inertia is read
        _ if is_record && holds_lists(group) => {
            return Group::new(Delimiter::Parenthesis, TokenStream::new());
        }
        _ if is_record && begins_with_number(group) => (Delimiter::Parenthesis, String::new()),
        _ if is_record || !is_call => return group.clone(),
        Delimiter::Parenthesis => (
            written,
            format!("arguments have no names: write `{word}({})`", values(group)),
        ),
        _ if named => (
            Delimiter::Parenthesis,
            format!("arguments go in parentheses and have no names: write `{word}(..)`"),
        ),
        _ => {
            let dot = if is_method { "." } else { "" };
            let message = format!("arguments go in parentheses: write `{dot}{word}(..)`");
            (Delimiter::Parenthesis, message)
        }
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

/// Whether braces behind this token hold named entries.
pub fn is_record(before: Option<&TokenTree>) -> bool {
    let is_word = |record: &&str| matches!(before, Some(TokenTree::Ident(word)) if word == record);
    RECORDS.iter().any(is_word)
}

/// The arguments in a group without their names, unless they are long.
fn values(group: &Group) -> String {
    let written = to_text(&without_names(group.stream()));
    if written.chars().count() > ARGUMENTS {
        return "..".to_owned();
    }
    written
}

/// Whether a group holds lists in brackets.
fn holds_lists(group: &Group) -> bool {
    let mut tokens = group.stream().into_iter();
    tokens.any(|token| matches!(token, TokenTree::Group(list) if list.delimiter() == Delimiter::Bracket && has_comma(&list)))
}

/// The component that a group means if it holds the number of one, as in `velocity[0]`. `[1]` is
/// the unit of pure numbers.
pub fn component_meant(group: &Group) -> Option<char> {
    match group.stream().to_string().as_str() {
        "0" => Some('x'),
        "2" => Some('z'),
        _ => None,
    }
}

/// Reports parentheses behind a number, or behind other ones if they hold a unit:
/// `9.81(m / s ^ 2)`; and a unit in braces, where these are no branch. They can be left out.
pub fn behind_number(tokens: &[TokenTree], index: usize, errors: &mut Errors) -> bool {
    let (before, rest) = tokens.split_at(index);
    let [TokenTree::Group(group), after @ ..] = rest else {
        return false;
    };
    let is_parentheses = |group: &Group| group.delimiter() == Delimiter::Parenthesis;
    let is_if = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "if");
    let is_in_braces = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let mut own = before
        .iter()
        .rev()
        .take_while(|token| !is_punct(token, ','));
    // the condition of an `if` is followed by a branch
    let is_else = matches!(after.first(), Some(TokenTree::Ident(word)) if word == "else");
    let mut after = after.iter().take_while(|token| !is_punct(token, ','));
    let is_condition = !is_else && after.any(is_in_braces);
    let in_braces = is_in_braces(&rest[0]) && (is_condition || !own.any(is_if));
    let before = before.last();
    let number = match before {
        _ if !in_braces && !is_parentheses(group) => return false,
        Some(TokenTree::Literal(number)) => number.to_string(),
        Some(TokenTree::Group(before)) if is_parentheses(before) => "(..)".to_owned(),
        _ => return false,
    };
    let message = match written_unit(group) {
        Some(unit) => format!("a unit goes in square brackets: write `{number}[{unit}]`"),
        None if in_braces || matches!(before, Some(TokenTree::Group(_))) => return false,
        None => format!("a product is written with `*`: write `{number} * (..)`"),
    };
    errors.push(group.span_open(), message);
    true
}

/// Reports a unit in angle brackets, `1<kg>`. Returns the number of its tokens.
pub fn in_angles(
    before: Option<&TokenTree>,
    tokens: &[TokenTree],
    errors: &mut Errors,
) -> Option<usize> {
    let Some(TokenTree::Literal(number)) = before else {
        return None;
    };
    let [less, inner @ ..] = tokens else {
        return None;
    };
    let length = inner.iter().position(|token| is_punct(token, '>'))?;
    let unit = Group::new(
        Delimiter::Bracket,
        inner[..length].iter().cloned().collect(),
    );
    let unit = written_unit(&unit).filter(|unit| is_punct(less, '<') && !unit.is_empty())?;
    let place = Extent::from(less.span()).to(inner[length].span().into());
    errors.push(
        place,
        format!("a unit goes in square brackets: write `{number}[{unit}]`"),
    );
    Some(length + 2)
}

/// The unit in a group, as it should be written.
pub fn written_unit(group: &Group) -> Option<String> {
    let unit = silently(|errors| UnitExpression::parse(group, errors))?;
    let mut words = unit.factors.iter().map(|(word, _)| word.to_string());
    words
        .all(|word| is_unit(&word))
        .then(|| to_text(&group.stream()))
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

/// Whether brackets hold a list in place of an operand.
pub fn is_list(group: &Group, before: Option<&TokenTree>) -> bool {
    let is_alone = !before.is_some_and(ends_operand);
    group.delimiter() == Delimiter::Bracket || is_alone && has_comma(group)
}

/// Whether brackets in place of an operand hold one value, and no unit.
pub fn is_value_in_brackets(
    group: &Group,
    before: Option<&TokenTree>,
    function: Option<&Ident>,
) -> bool {
    is_list(group, before)
        && function.is_none_or(|word| word != "compose")
        && !has_comma(group)
        && !group.stream().is_empty()
        && written_unit(group).is_none()
}

/// Whether a word directly follows another operand.
pub fn is_second_operand(before: Option<&TokenTree>, word: &Ident) -> bool {
    let is_operand = match before {
        Some(TokenTree::Ident(first)) => !is_keyword(&first.to_string()) && first != "not",
        Some(TokenTree::Group(group)) => group.delimiter() != Delimiter::Brace,
        _ => false,
    };
    is_operand && !is_keyword(&word.to_string())
}

/// Whether square brackets after this token would hold a unit.
pub fn ends_operand(token: &TokenTree) -> bool {
    match token {
        TokenTree::Ident(word) => !matches!(word.to_string().as_str(), "if" | "else"),
        TokenTree::Literal(_) | TokenTree::Group(_) => true,
        TokenTree::Punct(_) => false,
    }
}
