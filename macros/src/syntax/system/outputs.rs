//! `reactions(elbow, wrist)` among the outputs: those of some joints.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use crate::errors::Errors;
use crate::syntax::tokens::{Entry, split, start};

use super::System;

impl System {
    /// The entry `outputs: [..]` without the joints in it, which are kept.
    pub(super) fn without_joints(
        &mut self,
        entry: &[TokenTree],
        errors: &mut Errors,
    ) -> Vec<TokenTree> {
        let tokens = entry.iter().map(|token| match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => {
                TokenTree::Group(self.without_names(group, errors))
            }
            other => other.clone(),
        });
        tokens.collect()
    }

    fn without_names(&mut self, list: &Group, errors: &mut Errors) -> Group {
        let mut kept: Vec<TokenTree> = Vec::new();
        for token in list.stream() {
            match (kept.last(), &token) {
                (Some(TokenTree::Ident(word)), TokenTree::Group(group))
                    if word == "reactions" && group.delimiter() == Delimiter::Parenthesis =>
                {
                    self.held = Some(joints(group, errors));
                }
                _ => kept.push(token),
            }
        }
        let mut without = Group::new(list.delimiter(), kept.into_iter().collect());
        without.set_span(list.span());
        without
    }
}

/// The names in the parentheses.
fn joints(group: &Group, errors: &mut Errors) -> Vec<Ident> {
    if group.stream().is_empty() {
        errors.push(
            group.span(),
            "of which joints? write `reactions(elbow)`, or `reactions` for those of all",
        );
    }
    let mut names = Vec::new();
    for entry in split(group.stream(), Entry::Declared, errors) {
        match entry.as_slice() {
            [TokenTree::Ident(name)] => names.push(name.clone()),
            [TokenTree::Ident(_), first, ..] | [first, ..] => {
                errors.push(
                    start(first),
                    "expected the name of a joint and nothing else",
                );
            }
            [] => {}
        }
    }
    names
}
