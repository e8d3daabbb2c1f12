//! Units as they are written in brackets: `[kg * m ^ 2]`, `[deg / s]`, `[1 / s]`.
//!
//! They are read from their tokens: Rust itself would take `kg * m ^ 2` for `(kg * m) ^ 2`.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use crate::errors::{Errors, Extent};

use super::tokens::group_beyond;
use super::words::is_keyword;

/// A product of powers of named units.
#[derive(Clone, Debug)]
pub struct UnitExpression {
    pub factors: Vec<(Ident, i32)>,
    pub extent: Extent,
}

/// The largest exponent of a unit.
const EXPONENT: i32 = 12;
/// Parentheses that may be nested in each other.
const NESTING: usize = 8;
/// Units that may be multiplied with each other.
const FACTORS: usize = 24;

impl UnitExpression {
    /// Reads a unit in its brackets; what is wrong with it is reported.
    pub fn parse(brackets: &Group, errors: &mut Errors) -> Option<Self> {
        let tokens = brackets.stream();
        if tokens.is_empty() {
            let message = "empty unit: write for example `[kg]`, or no brackets";
            errors.push(brackets.span(), message);
            return None;
        }
        let extent = Extent::of(&tokens);
        if group_beyond(&tokens, NESTING).is_some() {
            let message = format!("parentheses nested more than {NESTING} deep in a unit");
            errors.push(extent, message);
            return None;
        }
        let factors = product(tokens, brackets, errors)?;
        if factors.len() > FACTORS {
            let message = format!("a unit of more than {FACTORS} factors");
            errors.push(extent, message);
            return None;
        }
        Some(Self { factors, extent })
    }
}

type Factors = Vec<(Ident, i32)>;

/// `unit * unit / unit`, all that stands in `around`.
fn product(tokens: TokenStream, around: &Group, errors: &mut Errors) -> Option<Factors> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut rest = tokens.as_slice();
    let mut factors = power(&mut rest, around, errors)?;
    while let [operator, tail @ ..] = rest {
        let sign = match operator {
            TokenTree::Punct(sign) if sign.as_char() == '*' => 1,
            TokenTree::Punct(sign) if sign.as_char() == '/' => -1,
            TokenTree::Ident(word) => {
                errors.push(
                    word.span(),
                    format!("expected `*` or `/` between units: write `* {word}`"),
                );
                return None;
            }
            other => {
                errors.push(other.span(), "expected `*`, `/` or `^` between units");
                return None;
            }
        };
        if tail.is_empty() {
            errors.push(operator.span(), "expected a unit after this");
            return None;
        }
        rest = tail;
        let next = power(&mut rest, around, errors)?;
        factors.extend(next.into_iter().map(|(unit, power)| (unit, sign * power)));
    }
    Some(factors)
}

/// `unit`, `unit ^ exponent`, or the same of a product in parentheses.
fn power(rest: &mut &[TokenTree], around: &Group, errors: &mut Errors) -> Option<Factors> {
    let Some((first, tail)) = rest.split_first() else {
        errors.push(around.span(), "expected a unit such as `kg`, `m` or `N`");
        return None;
    };
    *rest = tail;
    let factors = match first {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => {
            product(group.stream(), group, errors)?
        }
        TokenTree::Literal(number) if number.to_string() == "1" => Vec::new(),
        TokenTree::Literal(number)
            if number.to_string().starts_with(|c: char| c.is_ascii_digit()) =>
        {
            errors.push(
                number.span(),
                "no number stands in a unit, except in `1 / unit`: write it in front of the \
                 brackets",
            );
            return None;
        }
        TokenTree::Ident(word) if word == "in" => {
            errors.push(
                word.span(),
                "`in` is a keyword of Rust: inches are written `inch`",
            );
            return None;
        }
        TokenTree::Ident(word) if !is_keyword(&word.to_string()) && word != "_" => {
            vec![(word.clone(), 1)]
        }
        other => {
            errors.push(other.span(), "expected a unit such as `kg`, `m` or `N`");
            return None;
        }
    };
    let [TokenTree::Punct(hat), tail @ ..] = *rest else {
        return Some(factors);
    };
    if hat.as_char() != '^' {
        return Some(factors);
    }
    let (exponent, place) = exponent(tail, hat.span().into(), rest, errors)?;
    let raised = factors.into_iter().map(|(unit, power)| {
        let power = power * exponent;
        (power.abs() <= EXPONENT).then_some((unit, power))
    });
    let raised: Option<Factors> = raised.collect();
    if raised.is_none() {
        errors.push(place, message());
    }
    raised
}

fn message() -> String {
    format!("the exponent of a unit is a whole number from -{EXPONENT} to {EXPONENT}")
}

/// `2`, `-2`, `(-2)`; moves `rest` behind it.
fn exponent<'t>(
    tokens: &'t [TokenTree],
    hat: Extent,
    rest: &mut &'t [TokenTree],
    errors: &mut Errors,
) -> Option<(i32, Extent)> {
    let inner: Vec<TokenTree>;
    let (digits, after) = match tokens {
        [TokenTree::Group(group), after @ ..] if group.delimiter() == Delimiter::Parenthesis => {
            inner = group.stream().into_iter().collect();
            (inner.as_slice(), after)
        }
        [TokenTree::Punct(_), _, after @ ..] => (&tokens[..2], after),
        [_, after @ ..] => (&tokens[..1], after),
        [] => {
            errors.push(hat, "expected a whole number after this, as in `m ^ 2`");
            return None;
        }
    };
    *rest = after;
    let (negative, number) = match digits {
        [TokenTree::Punct(minus), TokenTree::Literal(number)] if minus.as_char() == '-' => {
            (true, Some(number))
        }
        [TokenTree::Literal(number)] => (false, Some(number)),
        _ => (false, None),
    };
    let value = number
        .and_then(|number| number.to_string().parse::<i32>().ok())
        .filter(|value| *value <= EXPONENT);
    let place = digits.first().map_or(hat, |first| {
        let last = digits.last().unwrap_or(first);
        Extent::from(first.span()).to(last.span().into())
    });
    let Some(value) = value else {
        errors.push(place, message());
        return None;
    };
    Some((if negative { -value } else { value }, place))
}
