//! Units in brackets: `[kg * m ^ 2]`, `[deg / s]`, `[1 / s]`.
//!
//! They are read token by token: Rust itself would parse `kg * m ^ 2` as `(kg * m) ^ 2`.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use crate::errors::{Errors, Extent};

use super::bare_unit::BareUnit;
use super::tokens::{as_written, group_beyond};
use super::words::is_keyword;
use crate::fraction::Fraction;

/// A product of powers of named units.
#[derive(Clone, Debug)]
pub struct UnitExpression {
    pub factors: Vec<(Ident, Fraction)>,
    pub extent: Extent,
}

/// The largest exponent of a unit.
const EXPONENT: i64 = 12;
/// The most parentheses inside each other.
const NESTING: usize = 8;
/// The most factors.
const FACTORS: usize = 24;

impl UnitExpression {
    /// Reads a unit in brackets. Errors are reported.
    pub fn parse(brackets: &Group, errors: &mut Errors) -> Option<Self> {
        let tokens = brackets.stream();
        if tokens.is_empty() {
            let message = "empty unit: write for example `[kg]`, or no brackets";
            return errors.report(brackets.span(), message);
        }
        let extent = Extent::of(&tokens);
        if group_beyond(&tokens, NESTING).is_some() {
            let message = format!("parentheses nested more than {NESTING} deep in a unit");
            return errors.report(extent, message);
        }
        let factors = product(tokens, brackets, errors)?;
        if factors.len() > FACTORS {
            let message = format!("a unit of more than {FACTORS} factors");
            return errors.report(extent, message);
        }
        Some(Self { factors, extent })
    }
}

type Factors = Vec<(Ident, Fraction)>;

/// `unit * unit / unit`, which must be the whole content of `around`.
fn product(tokens: TokenStream, around: &Group, errors: &mut Errors) -> Option<Factors> {
    let tokens = as_written(tokens);
    let mut rest = tokens.as_slice();
    let mut factors = power(&mut rest, around, errors)?;
    while let [operator, tail @ ..] = rest {
        let is_below = match operator {
            TokenTree::Punct(sign) if sign.as_char() == '*' => false,
            TokenTree::Punct(sign) if sign.as_char() == '/' => true,
            TokenTree::Ident(word) => {
                let unit = BareUnit::read(word, tail).written;
                return errors.report(
                    word.span(),
                    format!("expected `*` or `/` between units: write `* {unit}`"),
                );
            }
            TokenTree::Punct(dot) if dot.as_char() == '.' => {
                return errors.report(
                    dot.span(),
                    "a product of units is written `*`, as in `N * m`",
                );
            }
            other => {
                return errors.report(other.span(), "expected `*`, `/` or `^` between units");
            }
        };
        if tail.is_empty() {
            return errors.report(operator.span(), "expected a unit after this");
        }
        rest = tail;
        let next = power(&mut rest, around, errors)?;
        let signed = |power: Fraction| if is_below { power.negative() } else { power };
        factors.extend(next.into_iter().map(|(unit, power)| (unit, signed(power))));
    }
    Some(factors)
}

/// `unit`, `unit ^ exponent`, or the same for a product in parentheses.
fn power(rest: &mut &[TokenTree], around: &Group, errors: &mut Errors) -> Option<Factors> {
    let Some((first, tail)) = rest.split_first() else {
        return errors.report(around.span(), "expected a unit such as `kg`, `m` or `N`");
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
            return errors.report(
                number.span(),
                "a unit contains no number, except in `1 / unit`: write it in front of the \
                 brackets",
            );
        }
        TokenTree::Ident(word) if word == "in" => {
            return errors.report(
                word.span(),
                "`in` is a keyword of Rust: inches are written `inch`",
            );
        }
        TokenTree::Ident(word) if !is_keyword(&word.to_string()) && word != "_" => {
            vec![(word.clone(), Fraction::ONE)]
        }
        TokenTree::Punct(star) if star.as_char() == '*' => {
            return errors.report(star.span(), "a power is written `^`, as in `s ^ 2`");
        }
        TokenTree::Literal(_) => {
            return errors.report(first.span(), "a unit has no quotes, as in `[kg]`");
        }
        other => {
            return errors.report(other.span(), "expected a unit such as `kg`, `m` or `N`");
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
        let power = power.times(exponent)?;
        is_small(power).then_some((unit, power))
    });
    let raised: Option<Factors> = raised.collect();
    if raised.is_none() {
        errors.push(place, message());
    }
    raised
}

fn message() -> String {
    format!(
        "the exponent of a unit is a whole number from -{EXPONENT} to {EXPONENT}, or a fraction of \
         such numbers in parentheses, as in `m ^ (3/2)`"
    )
}

fn is_small(exponent: Fraction) -> bool {
    let (numerator, denominator) = exponent.parts();
    numerator.abs() <= EXPONENT && denominator <= EXPONENT
}

/// `2`, `-2`, `(-2)`, `(3/2)`; advances `rest` past it.
fn exponent<'t>(
    tokens: &'t [TokenTree],
    hat: Extent,
    rest: &mut &'t [TokenTree],
    errors: &mut Errors,
) -> Option<(Fraction, Extent)> {
    let inner: Vec<TokenTree>;
    let (digits, after) = match tokens {
        [TokenTree::Group(group), after @ ..] if group.delimiter() == Delimiter::Parenthesis => {
            inner = group.stream().into_iter().collect();
            (inner.as_slice(), after)
        }
        [TokenTree::Punct(_), _, after @ ..] => (&tokens[..2], after),
        [_, after @ ..] => (&tokens[..1], after),
        [] => {
            return errors.report(hat, "expected a whole number after this, as in `m ^ 2`");
        }
    };
    *rest = after;
    let place = digits.first().map_or(hat, |first| {
        let last = digits.last().unwrap_or(first);
        Extent::from(first.span()).to(last.span().into())
    });
    let is_slash =
        |token: &TokenTree| matches!(token, TokenTree::Punct(sign) if sign.as_char() == '/');
    let slash = digits.iter().position(is_slash);
    let (above, below) = digits.split_at(slash.unwrap_or(digits.len()));
    let denominator = match below {
        [] => Some(1),
        [_, below @ ..] => whole_number(below),
    };
    if denominator == Some(0)
        && let Some(zero) = below.last()
    {
        return errors.report(zero.span(), "nothing can be divided by zero");
    }
    let exponent = whole_number(above)
        .zip(denominator)
        .and_then(|(above, below)| Fraction::new(above, below))
        .filter(|exponent| is_small(*exponent));
    if exponent.is_none() {
        errors.push(place, message());
    }
    Some((exponent?, place))
}

/// `2`, `-2`
fn whole_number(tokens: &[TokenTree]) -> Option<i64> {
    let (sign, number) = match tokens {
        [TokenTree::Punct(minus), TokenTree::Literal(number)] if minus.as_char() == '-' => {
            (-1, number)
        }
        [TokenTree::Literal(number)] => (1, number),
        _ => return None,
    };
    Some(sign * number.to_string().replace('_', "").parse::<i64>().ok()?)
}
