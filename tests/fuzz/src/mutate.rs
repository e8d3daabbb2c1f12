//! Changes some of the tokens of a description.

use core::iter::repeat_n;

use fastrand::Rng;
use proc_macro2::{Delimiter, TokenTree};

use crate::flat::Token;
use crate::generate::punct;
use crate::words::{Words, ident, literal, sign};

/// One of the descriptions, after a few mutations; one of 64 is left as it is.
pub fn mutant(corpus: &[Vec<Token>], words: &Words, rng: &mut Rng) -> Vec<Token> {
    let mut flat = corpus[rng.usize(..corpus.len())].clone();
    if rng.u8(..64) == 0 {
        return flat;
    }
    for _ in 0..=(rng.u8(..8) * rng.u8(..2)) {
        mutate(&mut flat, corpus, words, rng);
    }
    flat
}

fn mutate(flat: &mut Vec<Token>, corpus: &[Vec<Token>], words: &Words, rng: &mut Rng) {
    if flat.is_empty() {
        return;
    }
    let place = rng.usize(..flat.len());
    match rng.u8(..20) {
        0 | 1 => {
            flat.drain(stretch(flat, rng));
        }
        2 | 3 => {
            let copied = flat[stretch(flat, rng)].to_vec();
            insert(flat, place, copied);
        }
        4 | 5 => {
            let other = rng.usize(..flat.len());
            flat.swap(place, other);
        }
        6 | 7 => flat[place] = Token::Leaf(words.word(rng)),
        8 => flat[place] = Token::Leaf(sign(rng)),
        9..12 => {
            if let Some(place) = any(flat, rng, |token| matches!(token, TokenTree::Literal(_))) {
                flat[place] = Token::Leaf(words.number(rng));
            }
        }
        12 | 13 => {
            let other = &corpus[rng.usize(..corpus.len())];
            if !other.is_empty() {
                insert(flat, place, other[stretch(other, rng)].to_vec());
            }
        }
        14 | 15 => rename(flat, words, rng),
        16 => insert(flat, place, unit(rng)),
        17 => nest(flat, rng),
        18 => lengthen(flat, rng),
        _ => define(flat, rng),
    }
}

fn insert(flat: &mut Vec<Token>, place: usize, tokens: Vec<Token>) {
    flat.splice(place..place, tokens);
}

/// A token, a bracket with all that is in it, or some tokens in a row.
fn stretch(flat: &[Token], rng: &mut Rng) -> core::ops::Range<usize> {
    let first = rng.usize(..flat.len());
    let length = if matches!(flat[first], Token::Open(_)) && rng.bool() {
        let mut open = 0_usize;
        let end = flat[first..].iter().position(|token| {
            match token {
                Token::Open(_) => open += 1,
                Token::Close => open -= 1,
                Token::Leaf(_) => {}
            }
            open == 0
        });
        end.unwrap_or(0) + 1
    } else {
        1 + rng.usize(..6) * rng.usize(..3)
    };
    first..(first + length).min(flat.len())
}

/// The place of one of the tokens that are asked for.
fn any(flat: &[Token], rng: &mut Rng, wanted: impl Fn(&TokenTree) -> bool) -> Option<usize> {
    let places = flat.iter().enumerate();
    let places = places.filter(|(_, token)| matches!(token, Token::Leaf(leaf) if wanted(leaf)));
    let places: Vec<usize> = places.map(|(place, _)| place).collect();
    (!places.is_empty()).then(|| places[rng.usize(..places.len())])
}

/// A name, wherever it stands, becomes another one, or one that stands elsewhere in the description.
fn rename(flat: &mut [Token], words: &Words, rng: &mut Rng) {
    let is_name = |token: &TokenTree| matches!(token, TokenTree::Ident(_));
    let (Some(old), Some(new)) = (any(flat, rng, is_name), any(flat, rng, is_name)) else {
        return;
    };
    let (Token::Leaf(old), Token::Leaf(new)) = (flat[old].clone(), flat[new].clone()) else {
        return;
    };
    let old = old.to_string();
    let new = if rng.bool() { words.word(rng) } else { new };
    for token in flat {
        if matches!(token, Token::Leaf(leaf) if is_name(leaf) && leaf.to_string() == old) {
            *token = Token::Leaf(new.clone());
        }
    }
}

/// `[m ^ 2 ^ 2147483648 ..]`
fn unit(rng: &mut Rng) -> Vec<Token> {
    let units = ["m", "s", "kg", "deg", "ft", "N", "minute"];
    let exponents = [
        "1",
        "2",
        "12",
        "13",
        "64",
        "2147483647",
        "2147483648",
        "1.5",
        "0",
        "0x10",
    ];
    let mut flat = vec![Token::Open(Delimiter::Bracket)];
    for _ in 0..=(rng.usize(..4) * rng.usize(..10)) {
        let leaf = |text: TokenTree| Token::Leaf(text);
        flat.push(leaf(ident(units[rng.usize(..units.len())])));
        flat.push(leaf(punct(if rng.u8(..4) == 0 { '*' } else { '^' })));
        flat.push(leaf(literal(exponents[rng.usize(..exponents.len())])));
        flat.push(leaf(punct(if rng.bool() { '*' } else { '/' })));
    }
    flat.pop();
    flat.push(Token::Close);
    flat
}

/// How often something is repeated: mostly a few times, sometimes thousands.
fn times(rng: &mut Rng) -> usize {
    let octaves = if rng.u8(..16) == 0 { 13 } else { 6 };
    1 << rng.usize(..octaves)
}

/// Brackets, signs, methods or branches around or behind a token, one in the other.
fn nest(flat: &mut Vec<Token>, rng: &mut Rng) {
    let Some(place) = any(flat, rng, |token| !matches!(token, TokenTree::Punct(_))) else {
        return;
    };
    let count = times(rng);
    let Some(inner) = flat.get(place).cloned() else {
        return;
    };
    let delimiter = match rng.u8(..8) {
        0 => Delimiter::Bracket,
        1 => Delimiter::Brace,
        2 => Delimiter::None,
        _ => Delimiter::Parenthesis,
    };
    let leaf = |text: TokenTree| Token::Leaf(text);
    let mut nested = Vec::new();
    match rng.u8(..6) {
        0 | 1 => {
            nested.extend(repeat_n(Token::Open(delimiter), count));
            nested.push(inner);
            nested.extend(repeat_n(Token::Close, count));
        }
        2 => {
            let prefix = if rng.bool() { '-' } else { '!' };
            nested.extend(repeat_n(leaf(punct(prefix)), count));
            nested.push(inner);
        }
        3 => {
            nested.push(inner);
            let method = ["sin", "abs", "norm", "sqrt", "normalize"][rng.usize(..5)];
            for _ in 0..count {
                nested.extend([
                    leaf(punct('.')),
                    leaf(ident(method)),
                    Token::Open(Delimiter::Parenthesis),
                    Token::Close,
                ]);
            }
        }
        4 => {
            nested.push(inner);
            for _ in 0..count {
                nested.extend([
                    Token::Open(Delimiter::Bracket),
                    leaf(ident("m")),
                    Token::Close,
                ]);
            }
        }
        _ => {
            for _ in 0..count {
                nested.extend([
                    leaf(ident("if")),
                    leaf(ident("t")),
                    leaf(punct('<')),
                    leaf(literal("1")),
                ]);
                nested.extend([
                    Token::Open(Delimiter::Brace),
                    inner.clone(),
                    Token::Close,
                    leaf(ident("else")),
                ]);
            }
            nested.extend([Token::Open(Delimiter::Brace), inner, Token::Close]);
        }
    }
    flat.splice(place..=place, nested);
}

/// `x + x + ..`, `x * x * ..`, behind an operand.
fn lengthen(flat: &mut Vec<Token>, rng: &mut Rng) {
    let Some(place) = any(flat, rng, |token| !matches!(token, TokenTree::Punct(_))) else {
        return;
    };
    let operator = ['+', '-', '*', '/', '<', '^', ','][rng.usize(..7)];
    let step = [Token::Leaf(punct(operator)), flat[place].clone()];
    let steps = repeat_n(step, times(rng)).flatten().collect();
    insert(flat, place + 1, steps);
}

/// `a1 = a0 op a0, a2 = a1 op a1, ..` in front of an entry.
fn define(flat: &mut Vec<Token>, rng: &mut Rng) {
    let is_equals =
        |token: &TokenTree| matches!(token, TokenTree::Punct(sign) if sign.as_char() == '=');
    let Some(place) = any(flat, rng, is_equals).filter(|place| *place > 0) else {
        return;
    };
    let count = times(rng).min(512);
    let operator = ['+', '*', '/', '-'][rng.usize(..4)];
    let name = |index: usize| Token::Leaf(ident(&format!("a{index}")));
    let leaf = |sign: char| Token::Leaf(punct(sign));
    let mut entries = vec![
        name(0),
        leaf('='),
        Token::Leaf(ident(["t", "mass", "position"][rng.usize(..3)])),
        leaf(','),
    ];
    for index in 0..count {
        entries.extend([
            name(index + 1),
            leaf('='),
            name(index),
            leaf(operator),
            name(index),
            leaf(','),
        ]);
    }
    insert(flat, place - 1, entries);
}
