//! Errors of a description: collected with the place that has to change, reported all at once.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{ToTokens, quote_spanned};

/// The stretch of a description that an error underlines.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    first: Span,
    last: Span,
}

impl Extent {
    /// From the first to the last of these tokens.
    pub fn of(tokens: impl ToTokens) -> Self {
        let mut spans = tokens
            .into_token_stream()
            .into_iter()
            .map(|token| token.span());
        let first = spans.next().unwrap_or_else(Span::call_site);
        Self {
            first,
            last: spans.last().unwrap_or(first),
        }
    }

    pub fn to(self, end: Self) -> Self {
        Self {
            first: self.first,
            last: end.last,
        }
    }
}

impl From<Span> for Extent {
    fn from(span: Span) -> Self {
        Self {
            first: span,
            last: span,
        }
    }
}

/// The errors found so far. Whoever owns the bag has to look into it: [`Errors::finish`].
#[derive(Default)]
pub struct Errors {
    found: Vec<syn::Error>,
    finished: bool,
}

impl Errors {
    pub fn push(&mut self, place: impl Into<Extent>, message: impl core::fmt::Display) {
        let Extent { first, last } = place.into();
        let (start, end) = (quote_spanned!(first=> _), quote_spanned!(last=> _));
        self.found.push(syn::Error::new_spanned(
            [start, end].into_iter().collect::<TokenStream>(),
            message,
        ));
    }

    /// Takes over an error of syn.
    pub fn absorb(&mut self, error: syn::Error) {
        self.found.push(error);
    }

    pub fn len(&self) -> usize {
        self.found.len()
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// The value of a fallible step; an error goes into the bag.
    pub fn catch<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.absorb(error)).ok()
    }

    /// All errors as `compile_error!`s, or nothing.
    pub fn finish(mut self) -> Option<TokenStream> {
        self.finished = true;
        (!self.found.is_empty()).then(|| {
            self.found
                .iter()
                .map(syn::Error::to_compile_error)
                .collect()
        })
    }
}

impl Drop for Errors {
    fn drop(&mut self) {
        debug_assert!(
            self.finished || std::thread::panicking(),
            "errors were collected and never reported"
        );
    }
}

/// `name`, or the one of `known` that it was probably meant to be.
pub fn similar<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let close = |candidate: &&str| distance(name, candidate) <= 1 + name.len() / 4;
    known
        .into_iter()
        .filter(close)
        .min_by_key(|candidate| distance(name, candidate))
}

/// ` (did you mean ...?)`, or nothing.
pub fn hint<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    similar(name, known).map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// Levenshtein's edit distance.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// The deepest nesting of brackets in `tokens`, found without recursion.
pub fn nesting(tokens: &TokenStream) -> usize {
    let mut deepest = 0;
    let mut pending = vec![(tokens.clone(), 0)];
    while let Some((stream, depth)) = pending.pop() {
        deepest = deepest.max(depth);
        let groups = stream.into_iter().filter_map(|token| match token {
            TokenTree::Group(group) => Some((group.stream(), depth + 1)),
            _ => None,
        });
        pending.extend(groups);
    }
    deepest
}
