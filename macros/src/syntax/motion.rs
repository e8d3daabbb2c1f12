//! The value of `motion:`: a word; for a support or a rod, with arguments in parentheses.

use proc_macro2::{Ident, TokenTree};

use crate::errors::{Errors, Extent, similar};

use super::expression::{Expression, Kind};
use super::tokens::{is_punct, quoted_word, start, stream};
use super::{Motion, Support};

/// Kinds of motion about a support.
pub const SUPPORTS: [&str; 3] = ["pivot", "fixed_point", "fixed_axis"];
/// The kind of motion that takes an axis but no support.
pub const ROD: &str = "rod";

pub fn parse_motion(value: &[TokenTree], errors: &mut Errors) -> Option<Motion> {
    match value {
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
        [TokenTree::Literal(literal)] if quoted_word(literal).is_some() => {
            let word = quoted_word(literal)?;
            let message = format!("a kind of motion has no quotes: write `{word}`");
            errors.push(literal.span(), message);
            Some(Motion {
                word,
                support: None,
            })
        }
        [
            TokenTree::Ident(first),
            a,
            b,
            TokenTree::Ident(word),
            rest @ ..,
        ] if is_punct(a, ':') && is_punct(b, ':') => {
            let word = Ident::new(&snake(&word.to_string()), word.span());
            let message = format!("a kind of motion is one word: write `{word}`");
            errors.push(Extent::from(first.span()).to(word.span().into()), message);
            let word = core::iter::once(TokenTree::Ident(word));
            let rest: Vec<TokenTree> = word.chain(rest.iter().cloned()).collect();
            parse_motion(&rest, errors)
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

/// `fixed_point` for `FixedPoint`.
fn snake(word: &str) -> String {
    let mut written = String::new();
    for letter in word.chars() {
        if letter.is_uppercase() && !written.is_empty() {
            written.push('_');
        }
        written.extend(letter.to_lowercase());
    }
    written
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
