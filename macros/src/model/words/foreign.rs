//! What stands in the Rust of the user, and not in the description.

use proc_macro2::{Ident, TokenStream};

use crate::symbolic::{Foreign, Number};

use super::dimension::Dimension;

/// A constant, known once the body is built.
pub struct ForeignConstant {
    pub name: Ident,
    /// An expression of Rust.
    pub value: TokenStream,
}

/// A function of scalars, each in a unit, of which the factor to SI units is known.
pub struct ForeignFunction {
    pub name: Ident,
    pub arguments: Vec<(Ident, Number, Dimension)>,
    pub result: (Number, Dimension),
    pub path: TokenStream,
    /// By each argument, where it is given.
    pub derivatives: Vec<Option<TokenStream>>,
}

impl ForeignFunction {
    /// The function itself and its derivatives that are given: what each is called, and its path.
    pub fn given(&self) -> impl Iterator<Item = (String, &TokenStream)> {
        let name = &self.name;
        let derivatives = self.arguments.iter().zip(&self.derivatives);
        let derivatives = derivatives.filter_map(move |((argument, ..), path)| {
            Some((format!("{name}_by_{argument}"), path.as_ref()?))
        });
        core::iter::once((name.to_string(), &self.path)).chain(derivatives)
    }

    /// What it is called, or a derivative of it; `None` of one that is not given.
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
