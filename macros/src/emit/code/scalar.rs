//! The scalar of a body: `f64`, or the type parameter of its description. The path of the runtime
//! is made here and nowhere else.

use std::fmt::{Display, LowerExp};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::model::Outline;
use crate::symbolic::Number;

/// The path to the names that generated code uses.
pub fn private(outline: &Outline) -> TokenStream {
    let runtime = &outline.runtime;
    quote!(#runtime::private)
}

/// The number type of a body.
#[derive(Clone)]
pub struct Scalar {
    /// The name of the type parameter, for a generic body.
    name: Option<Ident>,
    /// Whether the body is generic: then its type is written with the scalar, even if that is
    /// `f64`.
    is_applied: bool,
    private: TokenStream,
}

impl Scalar {
    pub fn of(outline: &Outline) -> Self {
        Self {
            name: outline.scalar.clone(),
            is_applied: outline.scalar.is_some(),
            private: private(outline),
        }
    }

    /// `f64`, even for a generic body, for what is computed in doubles only.
    pub fn double(outline: &Outline) -> Self {
        Self {
            name: None,
            ..Self::of(outline)
        }
    }

    pub fn is_generic(&self) -> bool {
        self.name.is_some()
    }

    /// `f64` or `T`
    pub fn kind(&self) -> TokenStream {
        self.name
            .as_ref()
            .map_or_else(|| quote!(f64), |name| quote!(#name))
    }

    /// `<T: Scalar>`, after `impl`
    pub fn declared(&self) -> TokenStream {
        let private = &self.private;
        let name = self.name.iter();
        quote!(#(<#name: #private::Scalar>)*)
    }

    /// `<T>`, after a type
    pub fn applied(&self) -> TokenStream {
        let kind = self.is_applied.then(|| self.kind()).into_iter();
        quote!(#(<#kind>)*)
    }

    /// A numeric type of the runtime, as it is written in types and in expressions.
    pub fn holder(&self, name: &str) -> TokenStream {
        let (private, name) = (&self.private, format_ident!("{name}"));
        self.name.as_ref().map_or_else(
            || quote!(#private::#name),
            |scalar| quote!(#private::generic::#name::<#scalar>),
        )
    }

    /// A constant: a literal, or for a generic body a scalar made from the value `at_hand`.
    pub fn constant(&self, number: &Number, at_hand: &TokenStream) -> TokenStream {
        let double = number_literal(number.to_f64());
        if !self.is_generic() {
            return double;
        }
        let single = single_literal(number.to_f32());
        quote!(#at_hand.constant(#double, #single))
    }
}

/// A double, as the shortest literal that is read back as the same double.
pub fn number_literal(value: f64) -> TokenStream {
    let magnitude = value.abs();
    let plain = magnitude == 0.0 || (1e-5..1e16).contains(&magnitude);
    literal(value < 0.0, plain, magnitude)
}

/// The same in single precision. A number outside its range is infinite.
fn single_literal(value: f32) -> TokenStream {
    let magnitude = value.abs();
    if magnitude.is_infinite() {
        let sign = (value < 0.0).then(|| quote!(-));
        return quote!(#sign f32::INFINITY);
    }
    let plain = magnitude == 0.0 || (1e-5..1e7).contains(&magnitude);
    literal(value < 0.0, plain, magnitude)
}

fn literal(is_negative: bool, plain: bool, magnitude: impl Display + LowerExp) -> TokenStream {
    let mut text = if plain {
        format!("{magnitude}")
    } else {
        format!("{magnitude:e}")
    };
    if !text.contains(['.', 'e']) {
        text.push_str(".0");
    }
    let literal = text.parse();
    let literal = literal.unwrap_or_else(|_| Literal::f64_unsuffixed(0.0));
    let sign = is_negative.then(|| quote!(-));
    quote!(#sign #literal)
}
