//! The charges of a uniform field: `.on([q1.at(p1), q2.at(p2)])`.

use proc_macro2::Ident;

use crate::errors::Errors;

use crate::syntax::Charge;
use crate::syntax::expression::{Expression, Kind, Prefix};

/// The charges in the parentheses of `.on(..)`. Unreadable ones are reported.
pub fn parse_charges(on: &Ident, arguments: Vec<Expression>, errors: &mut Errors) -> Vec<Charge> {
    let list = match <[Expression; 1]>::try_from(arguments) {
        Ok([only]) => only.kind,
        Err(_) => Kind::Poisoned,
    };
    let Kind::List(entries) = list else {
        errors.push(
            on.span(),
            "`.on` takes the charges in brackets: write `.on([q1.at(p1), q2.at(p2)])`",
        );
        return vec![Charge::poisoned()];
    };
    if entries.is_empty() {
        errors.push(
            on.span(),
            "a field on no charges is no load: write `.on([q1.at(p1)])`",
        );
        return vec![Charge::poisoned()];
    }
    let charges = entries.into_iter();
    charges.map(|entry| parse_charge(entry, errors)).collect()
}

impl Charge {
    /// A charge whose error is reported.
    fn poisoned() -> Self {
        Self {
            charge: None,
            point: None,
        }
    }
}

/// `charge.at(point)`; a sign in front of it belongs to the charge.
fn parse_charge(entry: Expression, errors: &mut Errors) -> Charge {
    let extent = entry.extent;
    match entry.kind {
        Kind::Poisoned => Charge::poisoned(),
        Kind::Method(charge, method, mut arguments) if method == "at" && arguments.len() == 1 => {
            Charge {
                charge: Some(*charge),
                point: arguments.pop(),
            }
        }
        Kind::Prefix(Prefix::Minus, inner) => {
            let inner = parse_charge(*inner, errors);
            let charge = inner.charge.map(|charge| Expression {
                kind: Kind::Prefix(Prefix::Minus, Box::new(charge)),
                extent,
            });
            Charge {
                charge,
                point: inner.point,
            }
        }
        _ => {
            errors.push(
                extent,
                "expected a charge and where it is: write `q.at(P)`, and parentheses around a \
                 charge that is computed",
            );
            Charge::poisoned()
        }
    }
}
