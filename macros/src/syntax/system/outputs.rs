//! `reactions(elbow, wrist)` and `jacobian(hand.tip)` in `outputs`: the selected joints and points.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use crate::errors::{Errors, similar};
use crate::syntax::expression::Expression;
use crate::syntax::tokens::{Entry, split, start, stream, ungrouped};

use super::System;

impl System {
    /// The entry `outputs: [..]` without such arguments, which are stored separately.
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
            if let (Some(TokenTree::Ident(word)), TokenTree::Group(group)) =
                (kept.last_mut(), &token)
                && let Some(meant) = similar(&word.to_string(), [REACTIONS, JACOBIAN])
            {
                let message = format!("there is no output `{word}`: write `{meant}{group}`");
                errors.push(word.span(), message);
                *word = Ident::new(meant, word.span());
            }
            match (kept.last(), &token) {
                (Some(TokenTree::Ident(word)), TokenTree::Group(group))
                    if group.delimiter() == Delimiter::Parenthesis && word == REACTIONS =>
                {
                    self.held = Some(joints(group, errors));
                }
                (Some(TokenTree::Ident(word)), TokenTree::Group(group))
                    if group.delimiter() == Delimiter::Parenthesis && word == JACOBIAN =>
                {
                    self.points.extend(points(group, errors));
                }
                _ => kept.push(token),
            }
        }
        let bare = kept.iter().find_map(|token| match token {
            TokenTree::Ident(word) if word == JACOBIAN => Some(word.span()),
            _ => None,
        });
        if let (Some(place), true) = (bare, self.points.is_empty()) {
            errors.push(place, OF_WHICH);
        }
        let mut without = Group::new(list.delimiter(), kept.into_iter().collect());
        without.set_span(list.span());
        without
    }
}

const REACTIONS: &str = "reactions";
const JACOBIAN: &str = "jacobian";
const OF_WHICH: &str = "of which points? write `jacobian(arm.tip)`";

/// The points in the parentheses.
fn points(group: &Group, errors: &mut Errors) -> Vec<Expression> {
    let entries = split(group.stream(), Entry::Declared, errors);
    let points = entries.iter();
    let points = points.filter_map(|entry| Expression::parse(stream(entry), errors));
    points.collect()
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
        match &*ungrouped(&entry) {
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
