//! Tokens between commas. Lists are split before anything in them is read, so that a bad entry
//! hides no others. Nothing here recurses into nested user input.

use std::borrow::Cow;

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::{Lit, LitStr};

use crate::errors::Errors;

use super::bare_unit::{is_unit_word, lacks_brackets};
use super::words::is_keyword;

/// What entries look like, so that a missing comma can be noticed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Entry {
    /// `key: value`
    Key,
    /// `name`, `name[unit]` or `name = value`
    Declared,
    /// `name = value`
    Defined,
}

/// Splits at the commas of the outermost level, and where a comma seems to be missing.
pub fn split(tokens: TokenStream, entry: Entry, errors: &mut Errors) -> Vec<Vec<TokenTree>> {
    let mut entries = Vec::new();
    let mut current: Vec<TokenTree> = Vec::new();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        if is_punct(&token, ',') || is_punct(&token, ';') {
            if is_punct(&token, ';') {
                errors.push(token.span(), "expected a comma instead of this");
            } else if current.is_empty() {
                errors.push(
                    token.span(),
                    "there is nothing before this comma: leave it out",
                );
            }
            if !current.is_empty() {
                entries.push(core::mem::take(&mut current));
            }
            continue;
        }
        if let TokenTree::Ident(name) = &token
            && begins(entry, name, &current, tokens.peek())
        {
            errors.push(name.span(), format!("expected a comma before `{name}`"));
            entries.push(core::mem::take(&mut current));
        }
        current.push(token);
    }
    if !current.is_empty() {
        entries.push(current);
    }
    for entry in &mut entries {
        without_quotes(entry, errors);
    }
    entries
}

/// Whether `name` begins a new entry, although the previous token is not a comma.
fn begins(entry: Entry, name: &Ident, before: &[TokenTree], after: Option<&TokenTree>) -> bool {
    let follows_value = match before {
        [.., hash, TokenTree::Group(_)] if is_punct(hash, '#') => false,
        [.., TokenTree::Ident(before)] => !is_keyword(&before.to_string()),
        [.., TokenTree::Literal(_) | TokenTree::Group(_)] => true,
        _ => false,
    };
    let followed_by = |sign| after.is_some_and(|after| is_punct(after, sign));
    follows_value
        && match entry {
            Entry::Key => followed_by(':'),
            Entry::Declared if matches!(before, [TokenTree::Ident(word)] if word == "moving") => {
                false
            }
            Entry::Declared if !is_keyword(&name.to_string()) => {
                followed_by('=')
                    || !(lacks_brackets(before.last(), name)
                        || before.len() == 1 && is_unit_word(name))
            }
            // one word in front of a name belongs to it
            Entry::Defined if matches!(before, [TokenTree::Ident(_)]) => false,
            Entry::Declared | Entry::Defined => followed_by('='),
        }
}

pub fn is_punct(token: &TokenTree, sign: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign)
}

/// The sign and the value of `sign value`, unless `sign` is the first half of another sign.
pub fn after_sign(tokens: &[TokenTree], sign: char) -> Option<(&Punct, &[TokenTree])> {
    let [TokenTree::Punct(first), value @ ..] = tokens else {
        return None;
    };
    let doubled = value
        .first()
        .is_some_and(|next| is_punct(next, sign) || (sign == '=' && is_punct(next, '>')));
    (first.as_char() == sign && !doubled).then_some((first, value))
}

/// The name in `name = value` or `name: value` among the arguments of `function`, if the `=` is at `index`.
pub fn argument_name<'t>(
    tokens: &'t [TokenTree],
    index: usize,
    function: Option<&Ident>,
) -> Option<&'t Ident> {
    function.filter(|word| !is_keyword(&word.to_string()))?;
    let rest = &tokens[index..];
    after_sign(rest, '=').or_else(|| after_sign(rest, ':'))?;
    match &tokens[..index] {
        [TokenTree::Ident(name)] => Some(name),
        [.., comma, TokenTree::Ident(name)] if is_punct(comma, ',') => Some(name),
        _ => None,
    }
}

/// The group in square brackets, if `tokens` consist of nothing else.
pub fn bracketed(tokens: &[TokenTree]) -> Option<&Group> {
    match tokens {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Bracket => Some(group),
        _ => None,
    }
}

/// The tokens after documentation and other attributes. These are reported.
pub fn without_attributes<'t>(tokens: &'t [TokenTree], errors: &mut Errors) -> &'t [TokenTree] {
    let rest = skip_attributes(tokens);
    if let (true, Some(hash)) = (rest.len() < tokens.len(), tokens.first()) {
        errors.push(
            hash.span(),
            "documentation and attributes are not allowed here: comments begin with `//`",
        );
    }
    rest
}

/// The tokens after `#[..] #[..]`.
pub fn skip_attributes(tokens: &[TokenTree]) -> &[TokenTree] {
    let mut rest = tokens;
    while let [hash, TokenTree::Group(_), tail @ ..] = rest
        && is_punct(hash, '#')
    {
        rest = tail;
    }
    rest
}

/// A comma at this place.
pub fn comma(place: Span) -> TokenTree {
    let mut comma = Punct::new(',', Spacing::Alone);
    comma.set_span(place);
    TokenTree::Punct(comma)
}

/// The beginning of a token; for a group, its opening bracket.
pub fn start(token: &TokenTree) -> Span {
    match token {
        TokenTree::Group(group) => group.span_open(),
        other => other.span(),
    }
}

/// Tokens as a stream.
pub fn stream(tokens: &[TokenTree]) -> TokenStream {
    tokens.iter().cloned().collect()
}

/// The token after the first `count` ones, including those in brackets, found without recursion.
pub fn token_beyond(tokens: &TokenStream, count: usize) -> Option<TokenTree> {
    let mut seen = 0;
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(current) = open.last_mut() {
        let Some(token) = current.next() else {
            open.pop();
            continue;
        };
        seen += 1;
        if seen > count {
            return Some(token);
        }
        if let TokenTree::Group(group) = &token {
            open.push(group.stream().into_iter());
        }
    }
    None
}

/// The first group that is nested deeper than this, found without recursion.
pub fn group_beyond(tokens: &TokenStream, depth: usize) -> Option<Group> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(current) = open.last_mut() {
        match current.next() {
            Some(TokenTree::Group(group)) if open.len() > depth => return Some(group),
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(_) => {}
            None => {
                open.pop();
            }
        }
    }
    None
}

/// The string, if the value is one.
pub fn string(value: &[TokenTree]) -> Option<LitStr> {
    let [TokenTree::Literal(literal)] = value else {
        return None;
    };
    match Lit::new(literal.clone()) {
        Lit::Str(text) => Some(text),
        _ => None,
    }
}

/// The word in quotes.
pub fn quoted_word(literal: &Literal) -> Option<Ident> {
    let Lit::Str(text) = Lit::new(literal.clone()) else {
        return None;
    };
    text.parse::<Ident>().ok()
}

/// `"name" = ..` and `"key": ..` without the quotes, which are reported.
fn without_quotes(entry: &mut [TokenTree], errors: &mut Errors) {
    let [first @ TokenTree::Literal(_), sign, ..] = entry else {
        return;
    };
    let TokenTree::Literal(literal) = &*first else {
        return;
    };
    if let Some(word) = quoted_word(literal)
        && (is_punct(sign, ':') || is_punct(sign, '='))
    {
        errors.push(
            literal.span(),
            format!("a name has no quotes: write `{word}`"),
        );
        *first = TokenTree::Ident(word);
    }
}

pub fn is_parenthesized(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis)
}

pub fn has_comma(group: &Group) -> bool {
    group
        .stream()
        .into_iter()
        .any(|token| is_punct(&token, ','))
}

/// The tokens with commas in place of semicolons, which are reported once.
pub fn with_commas(tokens: TokenStream, errors: &mut Errors) -> TokenStream {
    let mut is_reported = false;
    let tokens = tokens.into_iter().map(|token| {
        if !is_punct(&token, ';') {
            return token;
        }
        if !is_reported {
            errors.push(token.span(), "expected a comma instead of this");
        }
        is_reported = true;
        comma(token.span())
    });
    tokens.collect()
}

/// The tokens that another macro has passed on as one, such as `$inertia:expr`.
pub fn ungrouped(value: &[TokenTree]) -> Cow<'_, [TokenTree]> {
    let mut value = Cow::Borrowed(value);
    while let [TokenTree::Group(group)] = &*value
        && group.delimiter() == Delimiter::None
    {
        value = Cow::Owned(group.stream().into_iter().collect());
    }
    value
}

/// Tokens in which those that another macro has passed on as one are as if they were written: single
/// ones alone, several in parentheses.
pub fn as_written(tokens: TokenStream) -> Vec<TokenTree> {
    let tokens = tokens.into_iter().map(|token| {
        let inner = ungrouped(core::slice::from_ref(&token));
        match (&*inner, &token) {
            ([single], _) => single.clone(),
            (several, TokenTree::Group(group)) => {
                let mut whole = Group::new(Delimiter::Parenthesis, stream(several));
                whole.set_span(group.span());
                TokenTree::Group(whole)
            }
            _ => token.clone(),
        }
    });
    tokens.collect()
}
