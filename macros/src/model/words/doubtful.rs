//! Functions and quotients that may have no value, and the reason.

use crate::errors::Extent;
use crate::symbolic::{Id, Number};

use super::shown::shown;

/// An expression of the description that has no value for some values of parameters.
pub struct Doubtful {
    /// The name of a function, or `/` for a quotient.
    pub word: String,
    pub operands: Vec<Id>,
    pub value: Id,
    pub place: Extent,
}

pub fn why_not(word: &str, operands: &[Number]) -> String {
    let [x, rest @ ..] = operands else {
        return format!("`{word}` has no value");
    };
    let of = shown(x);
    match (word, rest) {
        _ if operands.iter().any(is_nearly_whole) => format!(
            "`{word}` is not known here: thousands of bits do not decide whether its argument is exactly {of}; \
             write it as a number"
        ),
        ("/", _) => "this is zero, and nothing can be divided by it".to_owned(),
        ("powf", [y]) if x.is_negative() && !y.is_whole() => format!(
            "`powf` of {of} has no value: negative numbers have whole powers, and this exponent is {}",
            shown(y)
        ),
        ("powf" | "powi" | "recip", _) if x.is_zero() => {
            format!("`{word}` of 0 has no value: it divides by it")
        }
        ("exp" | "sinh" | "cosh" | "tanh" | "powf" | "powi", _) => {
            format!("`{word}` of {of} has no value: it is far beyond the range of `f64`")
        }
        _ => format!("`{word}` of {of} has no value"),
    }
}

/// Whether a number cannot be distinguished from an integer.
fn is_nearly_whole(number: &Number) -> bool {
    [-1, 0, 1]
        .into_iter()
        .any(|whole| (number.clone() - Number::integer(whole)).is_undecided())
}
