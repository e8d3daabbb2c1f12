//! Statements, written as equations.

use super::markup::{Row, name, operator, table, value};

/// If there are more statements than this, they are shown only as text.
const MOST: usize = 60;

/// The statements as aligned equations with the reasons above them, unless there are too many.
pub fn statements_on_page(text: &[String]) -> Option<String> {
    if text.is_empty() || text.len() > MOST {
        return None;
    }
    let rows = text.iter().map(|line| {
        if let Some(note) = line.strip_prefix("# ") {
            return Some(Row::Note(escaped(&in_symbols(note))));
        }
        let (left, right) = line.split_once(" = ")?;
        let right = format!("{}{}", operator("="), expression(right));
        Some(Row::Cells(vec![expression(left), right]))
    });
    rows.collect::<Option<Vec<_>>>().map(table)
}

/// A note, with the field's usual symbols.
fn in_symbols(note: &str) -> String {
    note.replace(" x ", " × ").replace("^-1", "⁻¹")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// An expression of generated code, in `MathML`.
fn expression(text: &str) -> String {
    let mut markup = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
        let length = if first.is_ascii_digit() {
            number_length(rest)
        } else if is_word(first) {
            rest.find(|letter| !is_word(letter)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (token, after) = rest.split_at(length);
        rest = after;
        match first {
            ' ' => {}
            '*' => markup.push_str("<mspace width=\"0.2em\"/>"),
            '-' => markup.push_str(&operator("−")),
            _ if first.is_ascii_digit() => {
                markup.push_str(&token.parse().map_or_else(|_| operator(token), value));
            }
            _ if is_word(first) => markup.push_str(&name(letter(token))),
            _ => markup.push_str(&operator(&escaped(token))),
        }
    }
    markup
}

/// The length of the number, including its exponent, that a text begins with.
fn number_length(text: &str) -> usize {
    let mut before = ' ';
    let end = text.find(|letter: char| {
        let is_sign = matches!(letter, '-' | '+') && before == 'e';
        before = letter;
        !(letter.is_ascii_digit() || matches!(letter, '.' | 'e') || is_sign)
    });
    end.unwrap_or(text.len())
}

/// The letter that is usual in the field for a component of the state.
fn letter(word: &str) -> &str {
    match word {
        "wx" => "ω_x",
        "wy" => "ω_y",
        "wz" => "ω_z",
        "qx" => "q_x",
        "qy" => "q_y",
        "qz" => "q_z",
        "qw" => "q_w",
        "angle" => "φ",
        _ => word,
    }
}
