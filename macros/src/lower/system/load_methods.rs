//! Methods after a load: `.on(joint)`, `.between(P, Q)`.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::syntax::{Expression, Kind};

/// The receiver and the arguments of `value.method(arguments)`.
pub fn behind<'e>(
    value: &'e Expression,
    method: &str,
) -> Option<(&'e Expression, &'e [Expression])> {
    match &value.kind {
        Kind::Method(receiver, word, arguments) if word == method => Some((receiver, arguments)),
        _ => None,
    }
}

/// A method that applies only to the last operand, such as `on` in `-x.on(joint)`, which means
/// `-(x.on(joint))`.
pub fn behind_operand<'e>(value: &'e Expression, methods: &[&str]) -> Option<&'e Ident> {
    let last = match &value.kind {
        Kind::Prefix(_, operand) => operand,
        Kind::Chain(_, steps) => &steps.last()?.operand,
        _ => return None,
    };
    match &last.kind {
        Kind::Method(_, word, _) => methods.iter().any(|method| word == method).then_some(word),
        _ => behind_operand(last, methods),
    }
}

/// Reports such a method: it must apply to the whole load.
pub fn report_operand<T>(word: &Ident, errors: &mut Errors) -> Option<T> {
    let message = format!(
        "`.{word}(..)` applies to the last operand only: put the whole load in parentheses, `(..).{word}(..)`"
    );
    errors.report(word.span(), message)
}
