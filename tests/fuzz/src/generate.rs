//! Token streams from scratch: trees of words, numbers, signs and brackets, bare or in the form of
//! a description.

use fastrand::Rng;
use proc_macro2::Delimiter;

use crate::flat::Token;
use crate::words::{Words, ident, sign};

const DELIMITERS: [Delimiter; 4] = [
    Delimiter::Parenthesis,
    Delimiter::Bracket,
    Delimiter::Brace,
    Delimiter::None,
];

/// Three of four are bare; the others have a name, braces and keys.
pub fn stream(words: &Words, rng: &mut Rng) -> Vec<Token> {
    let mut flat = Vec::new();
    if rng.u8(..4) > 0 {
        tree(words, rng, &mut flat);
        return flat;
    }
    flat.push(Token::Leaf(ident("Body")));
    flat.push(Token::Open(Delimiter::Brace));
    for _ in 0..rng.usize(..6) {
        flat.push(Token::Leaf(words.word(rng)));
        flat.push(Token::Leaf(punct(':')));
        if rng.bool() {
            flat.push(Token::Open(Delimiter::Bracket));
            for _ in 0..rng.usize(..4) {
                flat.push(Token::Leaf(words.word(rng)));
                flat.push(Token::Leaf(punct('=')));
                tree(words, rng, &mut flat);
                flat.push(Token::Leaf(punct(',')));
            }
            flat.push(Token::Close);
        } else {
            tree(words, rng, &mut flat);
        }
        flat.push(Token::Leaf(punct(',')));
    }
    flat.push(Token::Close);
    flat
}

/// Some tokens and brackets in brackets, and what is still open at the end is closed there.
fn tree(words: &Words, rng: &mut Rng, flat: &mut Vec<Token>) {
    let mut open = 0;
    for _ in 0..rng.usize(..24) {
        flat.push(match rng.u8(..16) {
            0..6 => Token::Leaf(words.word(rng)),
            6..9 => Token::Leaf(words.number(rng)),
            9..13 => Token::Leaf(sign(rng)),
            13 if open > 0 => {
                open -= 1;
                Token::Close
            }
            _ => {
                open += 1;
                Token::Open(DELIMITERS[rng.usize(..DELIMITERS.len())])
            }
        });
    }
    flat.extend(core::iter::repeat_n(Token::Close, open));
}

pub fn punct(sign: char) -> proc_macro2::TokenTree {
    proc_macro2::Punct::new(sign, proc_macro2::Spacing::Alone).into()
}
