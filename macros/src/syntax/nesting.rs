//! The depth of nesting in an expression, counted token by token.

use proc_macro2::{Delimiter, TokenTree};

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
