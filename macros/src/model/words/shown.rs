//! Numbers in messages.

use crate::symbolic::Number;

/// A number in a message.
pub fn shown(number: &Number) -> String {
    let value = number.to_f64();
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}
