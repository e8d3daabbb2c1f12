//! Tokens as a flat list, with brackets as two separate tokens, so that a mutation is a change of a
//! list.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// A token, or one side of a bracket.
#[derive(Clone, Debug)]
pub enum Token {
    Open(Delimiter),
    Close,
    Leaf(TokenTree),
}

/// The tokens of a stream in a row, found without recursion.
pub fn flatten(stream: TokenStream) -> Vec<Token> {
    let mut flat = Vec::new();
    let mut open = vec![stream.into_iter()];
    while let Some(current) = open.last_mut() {
        match current.next() {
            Some(TokenTree::Group(group)) => {
                flat.push(Token::Open(group.delimiter()));
                open.push(group.stream().into_iter());
            }
            Some(leaf) => flat.push(Token::Leaf(leaf)),
            None => {
                open.pop();
                if !open.is_empty() {
                    flat.push(Token::Close);
                }
            }
        }
    }
    flat
}

/// The stream of these tokens: a bracket that is closed and was not opened is left out, one that is opened is closed at the end.
pub fn unflatten(flat: &[Token]) -> TokenStream {
    let mut open: Vec<(Delimiter, Vec<TokenTree>)> = vec![(Delimiter::None, Vec::new())];
    let close = |open: &mut Vec<(Delimiter, Vec<TokenTree>)>| {
        if open.len() > 1
            && let Some((delimiter, inner)) = open.pop()
            && let Some((_, around)) = open.last_mut()
        {
            let group = Group::new(delimiter, inner.into_iter().collect());
            around.push(group.into());
        }
    };
    for token in flat {
        match token {
            Token::Open(delimiter) => open.push((*delimiter, Vec::new())),
            Token::Close => close(&mut open),
            Token::Leaf(leaf) => {
                if let Some((_, current)) = open.last_mut() {
                    current.push(leaf.clone());
                }
            }
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.pop()
        .map(|(_, tokens)| tokens.into_iter().collect())
        .unwrap_or_default()
}
