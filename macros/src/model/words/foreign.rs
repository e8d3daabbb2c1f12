//! Rust items of the user that a description refers to.

use proc_macro2::{Ident, TokenStream};

use crate::symbolic::{Foreign, Number};

use super::dimension::Dimension;

/// A constant whose value is known once the body is built.
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
    /// The paths of the function and of its derivatives. Each comes with the arguments that it is
    /// differentiated with respect to, in order.
    pub paths: Vec<(Vec<usize>, TokenStream)>,
}

impl ForeignFunction {
    /// The function and its given derivatives, each with its name and path.
    pub fn given(&self) -> impl Iterator<Item = (String, &TokenStream)> {
        self.paths.iter().map(|(by, path)| (self.named(by), path))
    }

    /// The name of the function or of one of its derivatives; `None` for a derivative that is not
    /// given.
    pub fn word(&self, which: Foreign) -> Option<String> {
        let is_it =
            |by: &[usize]| by.iter().fold(which.without(), |one, place| one.by(*place)) == which;
        let (by, _) = self.paths.iter().find(|(by, _)| is_it(by))?;
        Some(self.named(by))
    }

    /// A name such as `lift`, `lift_by_alpha` or `lift_by_alpha_by_speed`.
    pub fn named(&self, by: &[usize]) -> String {
        let arguments = by
            .iter()
            .map(|place| format!("_by_{}", self.arguments[*place].0));
        core::iter::once(self.name.to_string())
            .chain(arguments)
            .collect()
    }
}
