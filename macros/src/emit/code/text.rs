//! Generated code as text, for the documentation.

use proc_macro2::TokenStream;

use crate::text::to_text;

/// Generated code as a line of text.
pub fn code_text(tokens: &TokenStream) -> String {
    let text = to_text(tokens);
    // `$crate::private::math::sin(x)` and `self.inverse_mass` are easier to read without their
    // paths
    let functions = without_path(&text, "private::math::");
    without_guards(&without_path(&functions, "private::")).replace("self.", "")
}

/// Writes `determined(divisor, scale)` as the quotient that it computes.
fn without_guards(text: &str) -> String {
    let parts = text.split_once("determined(").and_then(|(before, call)| {
        let comma = outside(call, ',')?;
        let close = outside(call, ')')?;
        Some((before, &call[..comma], &call[close + 1..]))
    });
    let Some((before, divisor, after)) = parts else {
        return text.to_owned();
    };
    if before.is_empty() && after.is_empty() {
        return format!("1 / {divisor}");
    }
    format!("{before}(1 / {divisor}){}", without_guards(after))
}

/// The first place of a sign that is not inside of parentheses.
fn outside(text: &str, sign: char) -> Option<usize> {
    let mut depth = 0_u32;
    for (place, c) in text.char_indices() {
        match c {
            _ if depth == 0 && c == sign => return Some(place),
            '(' => depth += 1,
            ')' => depth = depth.checked_sub(1)?,
            _ => {}
        }
    }
    None
}

/// Removes a path that ends like this, whatever it begins with.
fn without_path(text: &str, end: &str) -> String {
    let is_path = |c: char| c.is_alphanumeric() || matches!(c, '_' | ':' | '$');
    let mut parts: Vec<&str> = text.split(end).collect();
    let last = parts.pop().unwrap_or_default();
    let before = parts.iter().map(|part| part.trim_end_matches(is_path));
    before.collect::<String>() + last
}
