//! Rust items of the user that a description refers to.

use proc_macro2::{Ident, TokenStream};

use crate::symbolic::{Foreign, Number};

use super::dimension::Dimension;

/// A constant, known once the body is built.
pub struct ForeignConstant {
    pub name: Ident,
    /// A Rust expression.
    pub value: TokenStream,
}

/// A function of scalars, each in a unit with a known factor to SI units.
pub struct ForeignFunction {
    pub name: Ident,
    pub arguments: Vec<(Ident, Number, Dimension)>,
    pub result: (Number, Dimension),
    pub path: TokenStream,
    /// Derivatives by each argument, if given.
    pub derivatives: Vec<Option<TokenStream>>,
}

impl ForeignFunction {
    /// The function itself and its given derivatives: the name and path of each.
    pub fn given(&self) -> impl Iterator<Item = (String, &TokenStream)> {
        let name = &self.name;
        let derivatives = self.arguments.iter().zip(&self.derivatives);
        let derivatives = derivatives.filter_map(move |((argument, ..), path)| {
            Some((format!("{name}_by_{argument}"), path.as_ref()?))
        });
        core::iter::once((name.to_string(), &self.path)).chain(derivatives)
    }

    /// Its name, or that of a derivative; `None` for a derivative that is not given.
    pub fn word(&self, which: Foreign) -> Option<String> {
        let orders = which.orders();
        let argument = orders.iter().position(|order| *order > 0);
        match (orders.iter().sum(), argument) {
            (0, _) => Some(self.name.to_string()),
            (1, Some(place)) if matches!(self.derivatives.get(place), Some(Some(_))) => {
                let (argument, ..) = &self.arguments[place];
                Some(format!("{}_by_{argument}", self.name))
            }
            _ => None,
        }
    }
}
