//! Definitions: `name = value`.

use proc_macro2::{Ident, TokenTree};

use crate::errors::Errors;
use crate::syntax::expression::Expression;
use crate::syntax::tokens::{after_sign, is_punct, start, stream};
use crate::syntax::{Definition, Value};

pub fn parse_definition(name: Ident, rest: &[TokenTree], errors: &mut Errors) -> Definition {
    let value = parse_value(&name, rest, errors);
    Definition { name, value }
}

/// A constraint. One that is written as an equation is reported.
pub fn parse_constraint(name: Ident, rest: &[TokenTree], errors: &mut Errors) -> Definition {
    let written = after_sign(rest, '=').map_or(rest, |(_, written)| written);
    let is_equation = |tokens: &[TokenTree]| {
        let equals = is_punct(&tokens[1], '=') && after_sign(&tokens[1..], '=').is_some();
        equals && !matches!(&tokens[0], TokenTree::Punct(_))
    };
    if let Some(at) = written.windows(3).position(is_equation) {
        let value = errors.report(
            written[at + 1].span(),
            "a constraint is what is kept at zero: write `left - right` instead of `left = right`",
        );
        return Definition { name, value };
    }
    parse_definition(name, rest, errors)
}

/// The value after the `=`.
pub fn parse_value(name: &Ident, rest: &[TokenTree], errors: &mut Errors) -> Value {
    let Some((_, value)) = after_sign(rest, '=') else {
        let place = rest.first().map_or(name.span(), start);
        let message = match rest.first() {
            Some(sign) if is_punct(sign, ':') => {
                format!("an entry is written with `=`: write `{name} = ..`")
            }
            _ => format!("expected a value: write `{name} = ..`"),
        };
        return errors.report(place, message);
    };
    if value.is_empty() {
        return errors.report(
            name.span(),
            format!("`{name}` has no value: write `{name} = ..`"),
        );
    }
    Expression::parse(stream(value), errors)
}
