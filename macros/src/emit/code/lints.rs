//! Lints of the user that generated code could trigger, and the attributes that allow it to.

use std::f64::consts;

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

/// The attribute that allows literals in `code` that happen to be near a mathematical constant, for
/// which clippy would want the name of the constant. `None` if there is no such literal.
pub fn allow_constants(code: &TokenStream) -> Option<TokenStream> {
    has_constant(code.clone()).then(|| quote!(#[allow(clippy::approx_constant)]))
}

fn has_constant(code: TokenStream) -> bool {
    let is_near = |value: f64| {
        let near = |constant: &f64| (value / constant - 1.0).abs() < 2e-3;
        CONSTANTS.iter().any(near)
    };
    code.into_iter().any(|token| match token {
        TokenTree::Group(group) => has_constant(group.stream()),
        TokenTree::Literal(literal) => literal.to_string().parse().is_ok_and(is_near),
        _ => false,
    })
}

/// Constants that have names in std.
const CONSTANTS: [f64; 19] = [
    consts::PI,
    consts::TAU,
    consts::FRAC_PI_2,
    consts::FRAC_PI_3,
    consts::FRAC_PI_4,
    consts::FRAC_PI_6,
    consts::FRAC_PI_8,
    consts::FRAC_1_PI,
    consts::FRAC_2_PI,
    consts::FRAC_2_SQRT_PI,
    consts::SQRT_2,
    consts::FRAC_1_SQRT_2,
    consts::E,
    consts::LN_2,
    consts::LN_10,
    consts::LOG2_E,
    consts::LOG2_10,
    consts::LOG10_2,
    consts::LOG10_E,
];
