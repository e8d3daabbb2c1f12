//! The limits of an expression, and the depth of its nesting, counted token by token.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

use super::tokens::{group_beyond, start, token_beyond};

/// The most tokens of one expression. An error at this limit is better than a stack overflow.
const TOKENS: usize = 2000;
/// The most brackets inside each other.
const NESTING: usize = 48;
/// The most brackets, prefixes, methods and branches inside each other.
pub const DEPTH: usize = 128;

/// The token at which a limit is crossed, found without recursion.
pub fn crossed_limit(tokens: &TokenStream) -> Option<(Span, String)> {
    if let Some(group) = group_beyond(tokens, NESTING) {
        let message = format!(
            "brackets nested more than {NESTING} deep: name parts of this expression as `locals`"
        );
        return Some((group.span_open(), message));
    }
    let token = token_beyond(tokens, TOKENS)?;
    let message =
        format!("here this expression has more than {TOKENS} tokens: name parts of it as `locals`");
    Some((start(&token), message))
}

pub fn too_deep() -> String {
    format!("nested more than {DEPTH} deep: name parts of this expression as `locals`")
}

/// Nesting that needs no brackets.
#[derive(Default)]
pub struct Nested {
    /// Consecutive signs.
    signs: usize,
    /// Consecutive methods, fields and units.
    methods: usize,
    /// `if`s whose conditions are not finished.
    conditions: usize,
    /// Consecutive `else`s.
    branches: usize,
}

impl Nested {
    pub fn depth(&self) -> usize {
        self.signs + self.methods + self.conditions + self.branches
    }

    pub fn pass(
        &mut self,
        before: Option<&TokenTree>,
        token: &TokenTree,
        next: Option<&TokenTree>,
    ) {
        match token {
            TokenTree::Punct(sign) if sign.as_char() == '.' => {
                self.signs = 0;
                self.methods += 1;
            }
            TokenTree::Punct(_) => {
                self.signs += 1;
                self.methods = 0;
            }
            TokenTree::Group(group) if group.delimiter() != Delimiter::Brace => {
                self.signs = 0;
                let is_call = group.delimiter() == Delimiter::Parenthesis;
                let follows_group = matches!(before, Some(TokenTree::Group(_)));
                self.methods += usize::from(!is_call || follows_group);
            }
            TokenTree::Group(_) => {
                let goes_on = matches!(next, Some(TokenTree::Ident(word)) if word == "else");
                self.signs = 0;
                self.methods = 0;
                self.conditions = self.conditions.saturating_sub(1);
                if !goes_on && self.conditions == 0 {
                    self.branches = 0;
                }
            }
            TokenTree::Ident(word) => {
                self.signs = 0;
                self.conditions += usize::from(word == "if");
                self.branches += usize::from(word == "else");
            }
            TokenTree::Literal(_) => self.signs = 0,
        }
    }
}
