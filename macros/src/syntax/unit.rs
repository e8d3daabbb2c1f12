//! Units as they are written in brackets: `[kg * m ^ 2]`, `[deg / s]`, `[1 / s]`.
//!
//! They are read from their tokens: Rust itself would take `kg * m ^ 2` for `(kg * m) ^ 2`.

use proc_macro2::{Ident, TokenStream};
use syn::parse::{ParseStream, Parser};
use syn::{LitInt, Token, parenthesized, token};

use crate::errors::Extent;

/// A product of powers of named units.
#[derive(Clone, Debug)]
pub struct UnitExpression {
    pub factors: Vec<(Ident, i32)>,
    pub extent: Extent,
}

/// The largest exponent of a unit.
const EXPONENT: i32 = 12;

impl UnitExpression {
    /// Reads what stands between the brackets.
    pub fn parse(tokens: TokenStream, extent: Extent) -> syn::Result<Self> {
        if tokens.is_empty() {
            return Err(syn::Error::new_spanned(
                tokens,
                "empty unit: write for example `[kg]`, or no brackets",
            ));
        }
        let factors = product.parse2(tokens)?;
        Ok(Self { factors, extent })
    }
}

fn product(input: ParseStream<'_>) -> syn::Result<Vec<(Ident, i32)>> {
    let mut factors = power(input)?;
    while !input.is_empty() {
        if input.peek(Token![*]) {
            input.parse::<Token![*]>()?;
            factors.extend(power(input)?);
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            factors.extend(
                power(input)?
                    .into_iter()
                    .map(|(unit, exponent)| (unit, -exponent)),
            );
        } else {
            return Err(input.error("expected `*`, `/` or `^` between units"));
        }
    }
    Ok(factors)
}

fn power(input: ParseStream<'_>) -> syn::Result<Vec<(Ident, i32)>> {
    let factors = if input.peek(token::Paren) {
        let content;
        parenthesized!(content in input);
        product(&content)?
    } else if input.peek(LitInt) {
        let number: LitInt = input.parse()?;
        if number.to_string() != "1" {
            return Err(syn::Error::new(
                number.span(),
                "a unit has no number in it except `1 / unit`; put the number in front of the brackets",
            ));
        }
        Vec::new()
    } else if input.peek(syn::Ident) {
        vec![(input.parse()?, 1)]
    } else {
        return Err(input.error("expected a unit such as `kg`, `m` or `N`"));
    };
    if !input.peek(Token![^]) {
        return Ok(factors);
    }
    input.parse::<Token![^]>()?;
    let exponent = exponent(input)?;
    Ok(factors
        .into_iter()
        .map(|(unit, power)| (unit, power * exponent))
        .collect())
}

fn exponent(input: ParseStream<'_>) -> syn::Result<i32> {
    if input.peek(token::Paren) {
        let content;
        parenthesized!(content in input);
        return exponent(&content);
    }
    let negative = input.parse::<Option<Token![-]>>()?.is_some();
    let number: LitInt = input.parse().map_err(|error| {
        syn::Error::new(
            error.span(),
            "expected a whole number as the exponent of a unit",
        )
    })?;
    let value: i32 = number
        .to_string()
        .parse()
        .ok()
        .filter(|value| *value <= EXPONENT)
        .ok_or_else(|| {
            syn::Error::new(
                number.span(),
                format!("the exponent of a unit is a whole number up to {EXPONENT}"),
            )
        })?;
    Ok(if negative { -value } else { value })
}
