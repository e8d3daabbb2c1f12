//! Tokens as text, spaced as in a source.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// Tokens as a line of text.
pub fn to_text(tokens: &TokenStream) -> String {
    let mut text = String::new();
    let mut pending = reversed(tokens.clone());
    let mut closing: Vec<(usize, &str)> = Vec::new();
    let mut tight = true;
    while let Some(token) = pending.pop() {
        match token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Brace => ("{ ", " }"),
                    Delimiter::Bracket => ("[", "]"),
                    _ => ("(", ")"),
                };
                // of a call or an index, or a unit
                let called = text
                    .ends_with(|last: char| last.is_alphanumeric() || "_)]".contains(last))
                    && group.delimiter() != Delimiter::Brace;
                if !tight && !called {
                    text.push(' ');
                }
                text.push_str(open);
                closing.push((pending.len(), close));
                pending.extend(reversed(group.stream()));
                tight = true;
            }
            TokenTree::Punct(punct) => {
                let mark = punct.as_char();
                let glued = matches!(mark, '.' | ':' | ',') || tight;
                if !glued {
                    text.push(' ');
                }
                text.push(mark);
                let sign = tight && matches!(mark, '-' | '!');
                tight = matches!(mark, '.' | ':') || sign || punct.spacing() == Spacing::Joint;
            }
            other => {
                if !tight {
                    text.push(' ');
                }
                text.push_str(&other.to_string());
                tight = false;
            }
        }
        while closing
            .last()
            .is_some_and(|(left, _)| *left == pending.len())
        {
            text.push_str(closing.pop().map_or("", |(_, close)| close));
            tight = false;
        }
    }
    text
}

fn reversed(tokens: TokenStream) -> Vec<TokenTree> {
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    tokens.reverse();
    tokens
}
