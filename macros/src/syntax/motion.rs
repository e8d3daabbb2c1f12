//! The value of `motion:`: a word; for a support or a rod, with arguments in parentheses.

use proc_macro2::{Delimiter, Ident, TokenTree};

use crate::errors::{Errors, similar};

use super::expression::{Expression, Kind};
use super::tokens::{start, stream};
use super::{Motion, Support};

/// Kinds of motion about a support.
pub const SUPPORTS: [&str; 3] = ["pivot", "fixed_point", "fixed_axis"];
/// The kind of motion that takes an axis but no support.
pub const ROD: &str = "rod";

pub fn parse_motion(value: &[TokenTree], errors: &mut Errors) -> Option<Motion> {
    match value {
        // a group without delimiters: tokens passed on by another macro
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::None => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            parse_motion(&inner, errors)
        }
        [TokenTree::Ident(word)] => Some(Motion {
            word: word.clone(),
            support: None,
        }),
        [TokenTree::Ident(word), TokenTree::Group(_), ..]
            if word == ROD || is_support(&word.to_string()) =>
        {
            let written = Expression::parse(stream(value), errors);
            Some(Motion {
                word: word.clone(),
                support: Some(read_support(word, written, errors)),
            })
        }
        [] => None,
        [TokenTree::Ident(word), extra, ..] => {
            errors.push(start(extra), "nothing follows the kind of motion");
            Some(Motion {
                word: word.clone(),
                support: None,
            })
        }
        [first, ..] => errors.report(
            start(first),
            "expected a kind of motion: `planar`, `planar_translation`, `spatial`, \
                 `translation`, `rotation`, or one with a support such as `pivot(P)`",
        ),
    }
}

/// Whether a word is a kind of support, or is meant to be one.
fn is_support(word: &str) -> bool {
    SUPPORTS.contains(&word) || similar(word, SUPPORTS).is_some()
}

/// `word(arguments)` and `word(arguments).at(anchor)`; errors are reported.
fn read_support(word: &Ident, written: Option<Expression>, errors: &mut Errors) -> Support {
    let mut support = Support {
        arguments: vec![None],
        anchor: None,
        extent: word.span().into(),
    };
    let mut rest = written;
    while let Some(expression) = rest.take() {
        match expression.kind {
            Kind::Method(inner, method, mut arguments)
                if method == "at" && support.anchor.is_none() && arguments.len() == 1 =>
            {
                support.anchor = Some(arguments.pop());
                rest = Some(*inner);
            }
            Kind::Call(_, arguments) => {
                support.extent = expression.extent;
                support.arguments = arguments.into_iter().map(Some).collect();
            }
            kind => errors.push(
                match &kind {
                    Kind::Method(_, method, _) => method.span().into(),
                    _ => expression.extent,
                },
                if word == ROD {
                    "the motion of a rod is `rod(direction)`, such as `rod(body(1, 0, 0))`"
                        .to_owned()
                } else {
                    format!("a support is `{word}(P)`, or `{word}(P).at(world(..))` away from the origin")
                },
            ),
        }
    }
    support
}
