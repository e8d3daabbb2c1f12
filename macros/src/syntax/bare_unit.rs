//! Units whose brackets were forgotten: `9.81 m / s ^ 2`, `principal(1, 2, 3) kg m^2`.

use proc_macro2::{Delimiter, Ident, TokenTree};

use crate::errors::Extent;
use crate::units::{is_unit, unit_and_exponent};

use super::words::is_keyword;

/// A unit without brackets, at the beginning of a list of tokens.
pub struct BareUnit {
    /// As it should be written in brackets: `kg * m ^ 2`.
    pub written: String,
    /// The number of its tokens.
    pub length: usize,
    pub extent: Extent,
}

/// What a word behind a number means, if it is no unit.
pub fn meant_instead(number: &str, word: &str) -> Option<String> {
    let meant = match word {
        "and" => "`and` is written `&&`".to_owned(),
        "or" => "`or` is written `||`".to_owned(),
        "then" => "an `if` has braces: write `if .. { .. } else { .. }`".to_owned(),
        _ if names_unit(word) => return None,
        _ => {
            format!("`{word}` is no unit; a product is written with `*`: write `{number} * {word}`")
        }
    };
    Some(meant)
}

impl BareUnit {
    /// The longest unit that begins with `word` and continues in the tokens `after` it.
    pub fn read(word: &Ident, after: &[TokenTree]) -> Self {
        let mut unit = Self {
            written: factor(word),
            length: 1,
            extent: word.span().into(),
        };
        unit.exponent(after);
        while let Some((sign, word, tokens)) = next(&after[unit.length - 1..]) {
            unit.written.extend([' ', sign, ' ']);
            unit.written.push_str(&factor(word));
            unit.length += tokens;
            unit.extent = unit.extent.to(word.span().into());
            unit.exponent(after);
        }
        unit
    }

    /// Reads `^ 2`, `^ -2` or `^ (3/2)`, if that comes next.
    fn exponent(&mut self, after: &[TokenTree]) {
        let [hat, rest @ ..] = &after[self.length - 1..] else {
            return;
        };
        let (length, digits, span) = match rest {
            _ if !is_sign(hat, '^') => return,
            [minus, TokenTree::Literal(digits), ..] if is_sign(minus, '-') => {
                (2, format!("-{digits}"), digits.span())
            }
            [TokenTree::Literal(digits), ..] => (1, digits.to_string(), digits.span()),
            [TokenTree::Group(group), ..] if group.delimiter() == Delimiter::Parenthesis => {
                (1, group.to_string(), group.span())
            }
            _ => return,
        };
        self.written.push_str(" ^ ");
        self.written.push_str(&digits);
        self.length += 1 + length;
        self.extent = self.extent.to(span.into());
    }
}

/// Whether a word is probably meant as the unit of the operand just before it.
pub fn lacks_brackets(before: Option<&TokenTree>, word: &Ident) -> bool {
    match before {
        Some(TokenTree::Literal(_)) => !is_keyword(&word.to_string()),
        Some(TokenTree::Group(group)) => {
            // `t` is the time
            group.delimiter() != Delimiter::Bracket && is_unit_word(word) && word != "t"
        }
        _ => false,
    }
}

/// Whether a word is a unit, or a unit run together with its exponent.
pub fn is_unit_word(word: &Ident) -> bool {
    names_unit(&word.to_string())
}

fn names_unit(word: &str) -> bool {
    is_unit(word) || unit_and_exponent(word).is_some()
}

/// A unit as it should be written in brackets: `s ^ 2` for `s2`.
fn factor(word: &Ident) -> String {
    let word = word.to_string();
    match unit_and_exponent(&word) {
        Some((unit, digits)) => format!("{unit} ^ {digits}"),
        None => word,
    }
}

fn is_sign(token: &TokenTree, sign: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign)
}

/// The next factor, the sign that goes before it, and the number of their tokens.
fn next(rest: &[TokenTree]) -> Option<(char, &Ident, usize)> {
    let (sign, word, after) = match rest {
        [TokenTree::Ident(word), after @ ..] => ('*', word, after),
        [TokenTree::Punct(sign), TokenTree::Ident(word), after @ ..]
            if matches!(sign.as_char(), '*' | '/') =>
        {
            (sign.as_char(), word, after)
        }
        _ => return None,
    };
    let is_operand = match after.first() {
        Some(TokenTree::Group(_)) => true,
        Some(next) => is_sign(next, '.'),
        None => false,
    };
    (is_unit_word(word) && !is_operand).then(|| (sign, word, rest.len() - after.len()))
}
