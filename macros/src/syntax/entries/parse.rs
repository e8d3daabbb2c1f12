//! From tokens to a [`Description`]: its head and its keys.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use crate::errors::{Errors, Extent};

use super::checks::parse_check;
use super::composition::Composition;
use super::entry::{parse_entry, parse_name};
use super::keys::{
    LISTS, VALUES, bracketed_entry, further_braces, is_of_systems, key_meant, key_word, name_of,
    report_of_system, report_unknown,
};
use crate::syntax::expression::Expression;
use crate::syntax::head::parse_head;
use crate::syntax::motion::parse_motion;
use crate::syntax::tokens::{
    Entry, after_sign, is_punct, split, start, stream, string, token_beyond, ungrouped,
    without_attributes,
};
use crate::syntax::words::is_keyword;
use crate::syntax::{Description, Written};

/// The most tokens of a description. An error at this limit is better than minutes of waiting.
const TOKENS: usize = 50_000;

/// Parses `(runtime) Name { key: value, .. }`. Returns no description if the name is missing or the
/// text is too long.
pub fn parse_description(tokens: TokenStream, errors: &mut Errors) -> Option<Description> {
    check_length(&tokens, errors)?;
    let (mut description, body) = parse_head(tokens, errors)?;
    parse_keys(&mut description, body, errors);
    Some(description)
}

/// Reports a description that is too long, and returns `None` for it.
pub fn check_length(tokens: &TokenStream, errors: &mut Errors) -> Option<()> {
    let Some(crossed) = token_beyond(tokens, TOKENS) else {
        return Some(());
    };
    let message = format!(
        "here this description has more than {TOKENS} tokens: take forces together, or make them inputs"
    );
    errors.report(start(&crossed), message)
}

/// The keys of a body.
pub fn parse_keys(description: &mut Description, body: TokenStream, errors: &mut Errors) {
    // the last list without brackets: its further entries look like keys
    let mut open_list = None;
    for entry in split(body, Entry::Key, errors) {
        let entry = without_attributes(&entry, errors);
        match (entry, open_list) {
            ([TokenTree::Ident(name), rest @ ..], Some(list))
                if is_further(list, rest) && key_meant(&name.to_string()).is_none() =>
            {
                parse_one(description, list, entry, errors);
            }
            _ => open_list = parse_key(description, entry, errors),
        }
    }
}

/// Reads `key: value`. Returns the key of a list that lacks its brackets.
pub fn parse_key(
    into: &mut Description,
    entry: &[TokenTree],
    errors: &mut Errors,
) -> Option<&'static str> {
    let Some((key, rest)) = key_word(entry, errors) else {
        // references to a name that a `let` would define cause no further errors
        into.lost.extend(entry.get(1).and_then(name_of));
        return None;
    };
    let word = key.to_string();
    let meant = key_meant(&word);
    if let (Some(group), None) = (further_braces(rest), meant) {
        parse_further(into, key, group, errors);
        return None;
    }
    let value = ungrouped(key_value(key, rest, errors));
    let value = &*value;
    let exact = meant.is_some_and(|meant| meant == word);
    let repeated = into.keys.contains(key);
    if repeated && exact {
        let advice = if VALUES.contains(&word.as_str()) {
            "leave one of them out".to_owned()
        } else {
            format!("put everything into one `{word}: [..]`")
        };
        errors.push(key.span(), format!("`{word}` is given twice: {advice}"));
    }
    if is_of_systems(key) {
        report_of_system(into, key, errors);
        return None;
    }
    if !exact {
        report_unknown(key, meant, errors);
    }
    if !repeated {
        into.keys.push(key.clone());
    }
    let Some(meant) = meant else {
        into.lost.extend(names_in(value, errors));
        return None;
    };
    let Some((list, example)) = LISTS.iter().find(|(list, _)| *list == meant) else {
        parse_single(into, meant, value, errors);
        return None;
    };
    parse_list(into, list, example, value, errors)
}

/// Reports keys in further braces. They are read, unless they describe another body.
fn parse_further(into: &mut Description, word: &Ident, group: &Group, errors: &mut Errors) {
    if into.mass.is_some() || into.inertia.is_some() {
        let message = format!(
            "`{}` is one body: to describe `{word}` as well, write `rigid_system!`",
            into.name
        );
        errors.push(word.span(), message);
        return;
    }
    let message = format!(
        "the keys belong in the braces of `{}`: leave `{word}` and these braces out",
        into.name
    );
    errors.push(group.span_open(), message);
    parse_keys(into, group.stream(), errors);
}

/// The tokens after the colon, if there are any.
pub fn key_value<'t>(key: &Ident, rest: &'t [TokenTree], errors: &mut Errors) -> &'t [TokenTree] {
    let example = key_meant(&key.to_string())
        .and_then(|meant| LISTS.iter().find(|(list, _)| *list == meant))
        .map_or_else(|| format!("{key}: .."), |_| format!("{key}: [..]"));
    if let Some((_, value)) = after_sign(rest, ':') {
        if value.is_empty() {
            errors.push(
                key.span(),
                format!("`{key}` has no value: write `{example}`"),
            );
        }
        return value;
    }
    match rest {
        [] => {
            errors.push(
                key.span(),
                format!("`{key}` has no value: write `{example}`"),
            );
            rest
        }
        [TokenTree::Punct(sign), value @ ..] => {
            errors.push(
                sign.span(),
                format!("a key is followed by a colon: write `{example}`"),
            );
            match value {
                [second, value @ ..]
                    if is_punct(second, sign.as_char()) || is_punct(second, '>') =>
                {
                    value
                }
                _ => value,
            }
        }
        // a list in other brackets is reported as such
        [TokenTree::Group(group)]
            if group.delimiter() != Delimiter::Bracket
                && (example.ends_with(']') || key == "bodies" || key == "joints") =>
        {
            rest
        }
        [first, ..] => {
            errors.push(
                start(first),
                format!("expected a colon before this: write `{example}`"),
            );
            rest
        }
    }
}

/// The entries of `key: [ .. ]`, each parsed alone.
fn parse_list(
    into: &mut Description,
    list: &'static str,
    example: &str,
    value: &[TokenTree],
    errors: &mut Errors,
) -> Option<&'static str> {
    let group = match value {
        [TokenTree::Group(group)] => group,
        [] => return None,
        [first, rest @ ..] => {
            errors.push(
                start(first),
                format!("`{list}` is a list in brackets: write `{list}: [{example}]`"),
            );
            let is_entry = is_name(first) && is_further(list, rest);
            if is_entry {
                parse_one(into, list, value, errors);
            }
            return is_entry.then_some(list);
        }
    };
    if group.delimiter() != Delimiter::Bracket {
        errors.push(
            group.span_open(),
            format!("`{list}` is a list in brackets: write `{list}: [{example}]`"),
        );
    }
    let form = if is_declared(list) {
        Entry::Declared
    } else {
        Entry::Defined
    };
    for entry in split(group.stream(), form, errors) {
        let entry = bracketed_entry(group, entry);
        let entry = match list {
            "params" | "inputs" | "states" => take_texts(into, &entry),
            _ => &entry,
        };
        parse_one(into, list, without_attributes(entry, errors), errors);
    }
    None
}

/// Whether the entries of a list may be names without a value.
fn is_declared(list: &str) -> bool {
    matches!(list, "params" | "inputs" | "states" | "outputs")
}

/// Whether tokens after a name make it an entry of a list without brackets.
fn is_further(list: &str, after: &[TokenTree]) -> bool {
    match after.first() {
        None => is_declared(list),
        Some(TokenTree::Group(unit)) => is_declared(list) && unit.delimiter() == Delimiter::Bracket,
        Some(sign) => is_punct(sign, '='),
    }
}

fn is_name(token: &TokenTree) -> bool {
    name_of(token).is_some_and(|word| !is_keyword(&word))
}

/// Takes the documentation in front of a declaration, and returns the rest.
fn take_texts<'t>(into: &mut Description, entry: &'t [TokenTree]) -> &'t [TokenTree] {
    let (mut rest, mut lines) = (entry, Vec::new());
    while let [hash, TokenTree::Group(group), tail @ ..] = rest
        && is_punct(hash, '#')
        && let Some(line) = line_of_documentation(group)
    {
        lines.push(line);
        rest = tail;
    }
    if let (Some(name), false) = (rest.first().and_then(name_of), lines.is_empty()) {
        into.texts.push((name, lines));
    }
    rest
}

/// The text of `[doc = ".."]`, the form that Rust gives to `/// ..`.
fn line_of_documentation(group: &Group) -> Option<String> {
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Ident(word), equals, text @ ..] if word == "doc" && is_punct(equals, '=') => {
            string(text).map(|text| text.value())
        }
        _ => None,
    }
}

/// One entry of a list.
fn parse_one(into: &mut Description, list: &str, entry: &[TokenTree], errors: &mut Errors) {
    if list != "checks" {
        parse_entry(into, list, entry, errors);
    } else if let Some((name, rest)) = parse_name(into, list, entry, errors) {
        into.checks.push(parse_check(name, rest, errors));
    }
}

/// Reads a key that is not a list. If it occurs twice, the first value counts.
fn parse_single(into: &mut Description, key: &str, value: &[TokenTree], errors: &mut Errors) {
    let written = |errors: &mut Errors| {
        let value = (!value.is_empty()).then(|| Expression::parse(stream(value), errors));
        Some(Written {
            value: value.flatten(),
        })
    };
    match key {
        "doc" if into.doc.is_empty() => into.doc = parse_doc(value, errors),
        "motion" if into.motion.is_none() => into.motion = parse_motion(value, errors),
        "mass" if into.mass.is_none() => into.mass = written(errors),
        "inertia" if into.inertia.is_none() && into.composition.is_none() => {
            into.composition = Composition::parse(value, errors);
            if into.composition.is_some() {
                return;
            }
            into.inertia = match value.first() {
                Some(TokenTree::Group(group))
                    if group.delimiter() == Delimiter::Brace && begins_with_call(group) =>
                {
                    errors.push(group.span_open(), "leave these braces out");
                    Some(Written {
                        value: Expression::parse(group.stream(), errors),
                    })
                }
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                    errors.push(
                        group.span_open(),
                        "which entries are these? write `tensor { .. }` or `products { .. }`: \
                         they differ in the sign of the off-diagonals",
                    );
                    Some(Written { value: None })
                }
                _ => written(errors),
            }
        }
        "pole" if into.pole.is_none() => into.pole = written(errors),
        _ => {}
    }
}

/// Whether a group begins with `word(..)` or `word { .. }`.
fn begins_with_call(group: &Group) -> bool {
    let mut tokens = group.stream().into_iter();
    let (first, second) = (tokens.next(), tokens.next());
    first.as_ref().is_some_and(is_name) && matches!(second, Some(TokenTree::Group(_)))
}

/// The names that the entries of a list would define.
fn names_in(value: &[TokenTree], errors: &mut Errors) -> Vec<String> {
    let [TokenTree::Group(group)] = value else {
        return Vec::new();
    };
    split(group.stream(), Entry::Defined, errors)
        .iter()
        .filter_map(|entry| entry.first().and_then(name_of))
        .collect()
}

fn parse_doc(value: &[TokenTree], errors: &mut Errors) -> Vec<String> {
    if value.is_empty() {
        return Vec::new();
    }
    let Some(text) = string(value) else {
        errors.push(
            Extent::of(stream(value)),
            "expected a string: `doc: \"..\"`",
        );
        return Vec::new();
    };
    let text = text.value();
    text.lines().map(|line| line.trim().to_owned()).collect()
}
