//! Declarations of params, inputs and states: `arm = 0.2[m]`, `thrust[N]`.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::ToTokens;

use super::definition::parse_value;
use crate::errors::Errors;
use crate::syntax::Declaration;
use crate::syntax::bare_unit::{BareUnit, is_unit_word};
use crate::syntax::brackets::written_unit;
use crate::syntax::tokens::{is_punct, start, stream};
use crate::syntax::unit::UnitExpression;
use crate::text::to_text;

/// The error for `moving` before the unit or the name of an input.
pub const MOVING_BEFORE: &str = "`.moving` belongs at the end, as in `u[N].moving`: move it there";

pub fn parse_declaration(
    name: Ident,
    key: &str,
    rest: &[TokenTree],
    errors: &mut Errors,
) -> Declaration {
    let (rest, moving) = match rest {
        [rest @ .., TokenTree::Punct(dot), TokenTree::Ident(word)]
            if dot.as_char() == '.' && word == "moving" =>
        {
            (rest, Some(word.clone()))
        }
        [
            rest @ ..,
            TokenTree::Punct(dot),
            TokenTree::Ident(word),
            TokenTree::Group(group),
        ] if dot.as_char() == '.' && word == "moving" && is_empty(group) => {
            errors.push(group.span(), "write `.moving`, without parentheses");
            (rest, Some(word.clone()))
        }
        [TokenTree::Punct(dot), TokenTree::Ident(word), rest @ ..]
            if dot.as_char() == '.' && word == "moving" =>
        {
            if key == "inputs" {
                errors.push(word.span(), MOVING_BEFORE);
            }
            match rest {
                [TokenTree::Group(group), rest @ ..] if is_empty(group) => {
                    (rest, Some(word.clone()))
                }
                _ => (rest, Some(word.clone())),
            }
        }
        _ => (rest, None),
    };
    let (unit, value) = match rest {
        [] => (None, None),
        [TokenTree::Group(group), tail @ ..] if group.delimiter() == Delimiter::Bracket => {
            let unit = parse_unit(&name, key, group, tail, errors);
            let refused = unit.is_none();
            (unit, refused.then_some(None))
        }
        [TokenTree::Punct(colon), unit @ ..]
            if colon.as_char() == ':' && (key != "params" || !begins_value(unit)) =>
        {
            let message = match unit_meant(unit) {
                Some(unit) => format!("write `{name}[{unit}]`: a unit goes in brackets"),
                None if key == "inputs" => format!(
                    "an input has no type: write `{name}[unit]` for a scalar, or \
                     `{name} = world(_, _, _)[unit]` for a vector"
                ),
                None if key == "params" => {
                    format!("a param has no type: write `{name}[unit]`, or `{name} = 1[unit]`")
                }
                None => format!("a state has no type: write `{name}[unit]`"),
            };
            errors.push(colon.span(), message);
            (None, Some(None))
        }
        [TokenTree::Group(group), ..] if group.delimiter() == Delimiter::Parenthesis => {
            let message = match unit_meant(&rest[..1]) {
                Some(unit) if key != "params" => {
                    format!("a unit goes in brackets: write `{name}[{unit}]`")
                }
                _ => format!("expected `{name}`, `{name}[unit]` or `{name} = value`"),
            };
            errors.push(group.span_open(), message);
            (None, Some(None))
        }
        [TokenTree::Ident(word), after @ ..] if is_unit_word(word) => {
            let unit = BareUnit::read(word, after);
            let message = format!("a unit goes in brackets: write `{name}[{}]`", unit.written);
            errors.push(unit.extent, message);
            (None, Some(None))
        }
        _ => (None, Some(parse_value(&name, rest, errors))),
    };
    Declaration {
        name,
        unit,
        value,
        moving,
        order: 0,
    }
}

/// Whether tokens begin a value, rather than a unit or a type.
fn begins_value(tokens: &[TokenTree]) -> bool {
    match tokens.first() {
        Some(TokenTree::Ident(_)) => matches!(tokens.get(1), Some(TokenTree::Group(_))),
        Some(TokenTree::Group(group)) => group.delimiter() != Delimiter::Bracket,
        Some(_) => true,
        None => false,
    }
}

fn is_empty(parentheses: &Group) -> bool {
    parentheses.stream().is_empty() && parentheses.delimiter() == Delimiter::Parenthesis
}

/// The unit in brackets that ends a declaration.
fn parse_unit(
    name: &Ident,
    key: &str,
    group: &Group,
    tail: &[TokenTree],
    errors: &mut Errors,
) -> Option<UnitExpression> {
    let Some(next) = tail.first() else {
        return UnitExpression::parse(group, errors);
    };
    if key == "inputs" && is_punct(next, '.') {
        let message = format!("only `.moving` may follow the unit: write `{name}[..].moving`");
        return errors.report(start(next), message);
    }
    if !is_punct(next, '=') {
        let message = format!("expected `{name}`, `{name}[unit]` or `{name} = value`");
        return errors.report(start(next), message);
    }
    let unit = group.stream();
    let is_open = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "_");
    let message = if let ("inputs", [_, value @ .., TokenTree::Group(parts)]) = (key, tail)
        && parts.stream().into_iter().any(|token| is_open(&token))
    {
        let value: TokenStream = [stream(value), parts.to_token_stream()]
            .into_iter()
            .collect();
        let value = to_text(&value);
        format!("a unit follows the components: write `{name} = {value}[{unit}]`")
    } else if key == "inputs" {
        format!("an input has no value here: write `{name}[{unit}]`, or make it a param")
    } else {
        format!("a unit follows its number: write `{name} = ..[{unit}]`")
    };
    errors.report(group.span(), message)
}

/// The unit that is written without its brackets, or in other ones.
fn unit_meant(tokens: &[TokenTree]) -> Option<String> {
    let group = match tokens {
        [] => return Some("unit".to_owned()),
        [TokenTree::Group(group)] if group.delimiter() != Delimiter::Brace => group.clone(),
        _ => Group::new(Delimiter::Bracket, stream(tokens)),
    };
    written_unit(&group)
}
