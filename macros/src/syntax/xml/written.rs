//! Text in the language of descriptions, turned into expressions.

use core::str::FromStr;

use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};

use crate::errors::{Errors, Extent};
use crate::syntax::expression::{Expression, Kind};
use crate::syntax::{Definition, UnitExpression};

/// An expression. Errors about any part of it are reported at a place in a file.
pub fn written(text: &str, extent: Extent, span: Span, errors: &mut Errors) -> Option<Expression> {
    let tokens = TokenStream::from_str(text).ok()?;
    let mut expression = Expression::parse(spanned(tokens, span), errors)?;
    place(&mut expression, extent);
    Some(expression)
}

pub fn name(name: &str, span: Span) -> Ident {
    Ident::new(name, span)
}

pub fn definition(name: Ident, text: &str, extent: Extent, errors: &mut Errors) -> Definition {
    let value = written(text, extent, name.span(), errors);
    Definition { name, value }
}

/// `[N * m]` of a text such as `0[N * m]`.
pub fn unit(text: &str, extent: Extent, span: Span, errors: &mut Errors) -> Option<UnitExpression> {
    match written(text, extent, span, errors)?.kind {
        Kind::Unit(_, unit) => Some(unit),
        _ => None,
    }
}

fn spanned(tokens: TokenStream, span: Span) -> TokenStream {
    let tokens = tokens.into_iter().map(|token| match token {
        TokenTree::Group(group) => {
            let mut spanned_group = Group::new(group.delimiter(), spanned(group.stream(), span));
            spanned_group.set_span(span);
            TokenTree::Group(spanned_group)
        }
        mut token => {
            token.set_span(span);
            token
        }
    });
    tokens.collect()
}

/// Gives an expression and all of its parts the same place.
fn place(expression: &mut Expression, extent: Extent) {
    let mut pending = vec![expression];
    while let Some(part) = pending.pop() {
        part.extent = extent;
        visit(part, &mut pending);
    }
}

/// Replaces `_` by `value`.
pub fn filled(mut expression: Expression, value: &Expression) -> Expression {
    let mut pending = vec![&mut expression];
    while let Some(part) = pending.pop() {
        if matches!(part.kind, Kind::Placeholder) {
            *part = value.clone();
        } else {
            visit(part, &mut pending);
        }
    }
    expression
}

fn visit<'e>(part: &'e mut Expression, pending: &mut Vec<&'e mut Expression>) {
    match &mut part.kind {
        Kind::Number(_) | Kind::Name(_) | Kind::Text(_) | Kind::Placeholder | Kind::Poisoned => {}
        Kind::Tuple(parts) | Kind::List(parts) | Kind::Call(_, parts) => pending.extend(parts),
        Kind::Unit(operand, _) | Kind::Prefix(_, operand) | Kind::Field(operand, _) => {
            pending.push(operand);
        }
        Kind::Chain(first, steps) => {
            pending.push(first);
            pending.extend(steps.iter_mut().map(|step| &mut step.operand));
        }
        Kind::Method(receiver, _, arguments) => {
            pending.push(receiver);
            pending.extend(arguments);
        }
        Kind::Record(_, fields) => pending.extend(fields.iter_mut().map(|(_, value)| value)),
        Kind::If(parts) => pending.extend(parts.iter_mut()),
    }
}
