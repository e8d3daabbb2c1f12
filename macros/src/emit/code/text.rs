//! Generated code as text, for the documentation.

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
                let called = text.ends_with(|last: char| last.is_alphanumeric() || last == '_')
                    && group.delimiter() == Delimiter::Parenthesis;
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
    // `$crate::private::math::sin(x)` and `self.inverse_mass` are easier to read without their
    // paths
    let functions = without_path(&text, "private::math::");
    without_guards(&without_path(&functions, "private::")).replace("self.", "")
}

/// Writes `determined(divisor, scale)` as the quotient that it computes.
fn without_guards(text: &str) -> String {
    let parts = text.split_once("determined(").and_then(|(before, call)| {
        let (divisor, call) = call.split_once(", ")?;
        let (_, after) = call.split_once(')')?;
        Some((before, divisor, after))
    });
    let Some((before, divisor, after)) = parts else {
        return text.to_owned();
    };
    if before.is_empty() && after.is_empty() {
        return format!("1 / {divisor}");
    }
    format!("{before}(1 / {divisor}){}", without_guards(after))
}

/// Removes a path that ends like this, whatever it begins with.
fn without_path(text: &str, end: &str) -> String {
    let is_path = |c: char| c.is_alphanumeric() || matches!(c, '_' | ':' | '$');
    let mut parts: Vec<&str> = text.split(end).collect();
    let last = parts.pop().unwrap_or_default();
    let before = parts.iter().map(|part| part.trim_end_matches(is_path));
    before.collect::<String>() + last
}

fn reversed(tokens: TokenStream) -> Vec<TokenTree> {
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    tokens.reverse();
    tokens
}
