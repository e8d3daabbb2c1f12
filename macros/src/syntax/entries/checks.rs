//! Checks: `name = condition`, and the state for which it is checked:
//! `(condition).given(thrust = 2[N])`.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use crate::errors::Errors;

use super::definition::parse_value;
use crate::syntax::expression::{Expression, Kind, Operator};
use crate::syntax::tokens::{Entry, is_punct, split, start, stream, without_attributes};
use crate::syntax::{Check, Claim, Given};

const FORM: &str = "a check compares two scalars: write `a < b`, `<=`, `>`, `>=`, `==` or `!=`, and join several by `&&`";

/// The part of an entry after its name.
pub fn parse_check(name: Ident, rest: &[TokenTree], errors: &mut Errors) -> Check {
    let (mut rest, mut given) = (rest, None);
    while let Some((before, word, group)) = split_given(rest) {
        if given.is_some() {
            let message = "`.given(..)` is written twice: put all values into one";
            errors.push(word.span(), message);
        } else {
            given = Some(parse_given(word, group, errors));
        }
        rest = before;
    }
    let value = parse_value(&name, rest, errors);
    let mut claims = Vec::new();
    if let Some(value) = value {
        take_claims(value, &mut claims, errors);
    }
    Check {
        name,
        claims,
        given: given.unwrap_or_default(),
    }
}

/// What comes before `.given(..)`, its name and its values.
fn split_given(rest: &[TokenTree]) -> Option<(&[TokenTree], &Ident, &Group)> {
    let [
        before @ ..,
        TokenTree::Punct(dot),
        TokenTree::Ident(word),
        TokenTree::Group(group),
    ] = rest
    else {
        return None;
    };
    let is_given =
        dot.as_char() == '.' && word == "given" && group.delimiter() == Delimiter::Parenthesis;
    is_given.then_some((before, word, group))
}

/// Collects all comparisons joined by `&&`. Operators form a chain from left to right.
fn take_claims(mut value: Expression, claims: &mut Vec<Claim>, errors: &mut Errors) {
    let Kind::Chain(first, steps) = &mut value.kind else {
        if !matches!(value.kind, Kind::Poisoned) {
            errors.push(value.extent, FORM);
        }
        return;
    };
    let Some(last) = steps.pop() else {
        return;
    };
    let left = match steps.last() {
        None => (**first).clone(),
        Some(step) => Expression {
            extent: first.extent.to(step.operand.extent),
            kind: Kind::Chain(first.clone(), steps.clone()),
        },
    };
    match last.operator {
        Operator::And => {
            take_claims(left, claims, errors);
            take_claims(last.operand, claims, errors);
        }
        Operator::Less
        | Operator::LessOrEqual
        | Operator::Greater
        | Operator::GreaterOrEqual
        | Operator::Equal
        | Operator::NotEqual => claims.push(Claim {
            extent: left.extent.to(last.operand.extent),
            left,
            step: last,
        }),
        _ => errors.push(value.extent, FORM),
    }
}

/// `thrust = 2[N], elbow.angle = 30[deg]`
fn parse_given(word: &Ident, group: &Group, errors: &mut Errors) -> Vec<Given> {
    let entries = split(group.stream(), Entry::Defined, errors);
    if entries.is_empty() {
        errors.push(
            word.span(),
            "nothing is given: write `.given(thrust = 2[N])`, or leave it out",
        );
    }
    let given = entries.iter().filter_map(|entry| {
        let entry = without_attributes(entry, errors);
        let Some(sign) = entry.iter().position(|token| is_punct(token, '=')) else {
            let place = start(entry.first()?);
            return errors.report(place, "expected what is given: write `name = value`");
        };
        let (target, value) = entry.split_at(sign);
        if target.is_empty() || value.len() < 2 {
            let message = "expected what is given: write `name = value`";
            return errors.report(start(&entry[sign]), message);
        }
        let target = Expression::parse(stream(target), errors)?;
        let value = Expression::parse(stream(&value[1..]), errors)?;
        Some(Given { target, value })
    });
    given.collect()
}
