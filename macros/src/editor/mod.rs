//! What editors see of a description: each word becomes a field of a struct that fits its place.
//! The runtime requests this only when an editor reads the code, so rustc compiles none of it.

mod fields;
mod words;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::errors::Errors;
use crate::model::Outline;
use crate::{lower, syntax};
use fields::Scene;
use words::words;

/// The words of a body as code.
pub fn expand_words(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let description = syntax::parse_description(tokens.clone(), &mut errors);
    let outline = description.map(|description| lower::outline(&description, &[], &mut errors));
    emit(outline, tokens, errors)
}

/// The words of a system as code.
pub fn expand_words_of_system(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let system = syntax::parse_system(tokens.clone(), &mut errors);
    let outline = system.map(|system| {
        let mut outline = lower::outline(&system.top, &[], &mut errors);
        lower::outline_system(&system, &mut outline);
        outline
    });
    emit(outline, tokens, errors)
}

fn emit(outline: Option<Outline>, tokens: TokenStream, errors: Errors) -> TokenStream {
    // the expansion of the description reports these errors
    let _ = errors.finish();
    let words = words(braces(tokens).unwrap_or_default());
    outline.map_or_else(TokenStream::new, |outline| {
        Scene::new(&outline, &words).emit()
    })
}

/// The content of the braces of a description.
fn braces(tokens: TokenStream) -> Option<TokenStream> {
    tokens.into_iter().find_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
        _ => None,
    })
}
