//! Errors in a description. They are collected, each with the place that has to change, and
//! reported all at once.

mod suggestions;

pub use suggestions::{
    advice_for_key, declaration_meant, foreign_key_meant, foreign_list_meant, function_meant, hint,
    hint_of_joint, hint_of_motion, is_joint, name_meant, similar, solid_meant, unit_of,
    vector_method_meant,
};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

/// The part of a description that an error underlines.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    first: Span,
    last: Span,
    source: Option<Source>,
}

/// A place in a file that a description reads, by its index in `Errors`.
#[derive(Clone, Copy, Debug)]
pub struct Source(usize);

impl Extent {
    /// The extent from the first to the last of these tokens.
    pub fn of(tokens: impl ToTokens) -> Self {
        let mut spans = tokens
            .into_token_stream()
            .into_iter()
            .map(|token| token.span());
        let first = spans.next().unwrap_or_else(Span::call_site);
        Self {
            first,
            last: spans.last().unwrap_or(first),
            source: None,
        }
    }

    /// The same extent, for something at a place in a file.
    pub fn within(self, source: Source) -> Self {
        Self {
            source: Some(source),
            ..self
        }
    }

    /// The same place in a file, but with another token underlined.
    pub fn underlining(self, span: Span) -> Self {
        Self {
            first: span,
            last: span,
            ..self
        }
    }

    pub fn to(self, end: Self) -> Self {
        Self {
            first: self.first,
            last: end.last,
            source: self.source,
        }
    }
}

impl From<Span> for Extent {
    fn from(span: Span) -> Self {
        Self {
            first: span,
            last: span,
            source: None,
        }
    }
}

/// The errors found so far. The owner must call [`Errors::finish`].
#[derive(Default)]
pub struct Errors {
    found: Vec<syn::Error>,
    finished: bool,
    /// The places in files, as words.
    sources: Vec<String>,
}

impl Errors {
    pub fn push(&mut self, place: impl Into<Extent>, message: impl core::fmt::Display) {
        let Extent {
            first,
            last,
            source,
        } = place.into();
        let source = source.and_then(|Source(number)| self.sources.get(number));
        let message = source.map_or_else(
            || message.to_string(),
            |source| format!("{source}: {message}"),
        );
        let (start, end) = (quote_spanned!(first=> _), quote_spanned!(last=> _));
        self.found.push(syn::Error::new_spanned(
            [start, end].into_iter().collect::<TokenStream>(),
            message,
        ));
    }

    /// Reports an error, and returns `None` instead of a value.
    pub fn report<T>(
        &mut self,
        place: impl Into<Extent>,
        message: impl core::fmt::Display,
    ) -> Option<T> {
        self.push(place, message);
        None
    }

    /// Reports a name that nothing defines, once: it is one mistake, however often it is used.
    pub fn undefined<T>(&mut self, name: &Ident, advice: &str) -> Option<T> {
        let word = name.to_string();
        match word.strip_prefix("r#") {
            None => self.once(name, &format!("nothing here is called `{name}`"), advice),
            Some(plain) if syn::parse_str::<Ident>(plain).is_ok() => {
                self.once(name, &format!("write `{plain}`, without `r#`"), "")
            }
            Some(_) => self.keyword(name, ", and no name here"),
        }
    }

    /// Reports a keyword where a name is wanted, once.
    pub fn keyword<T>(&mut self, name: &Ident, advice: &str) -> Option<T> {
        let word = name.to_string();
        let plain = word.trim_start_matches("r#");
        self.once(name, &format!("`{plain}` is a keyword of Rust"), advice)
    }

    /// Reports an error at a name, if no other one begins with this message.
    fn once<T>(&mut self, name: &Ident, message: &str, advice: &str) -> Option<T> {
        let is_it = |error: &syn::Error| error.to_string().starts_with(message);
        if self.found.iter().any(is_it) {
            return None;
        }
        self.report(name.span(), format!("{message}{advice}"))
    }

    /// Registers a place in a file. Errors that are found there mention it.
    pub fn source(&mut self, words: String) -> Source {
        self.sources.push(words);
        Source(self.sources.len() - 1)
    }

    pub fn count(&self) -> usize {
        self.found.len()
    }

    /// Forgets the errors after the first `count`, because their source will be read again.
    pub fn take_back(&mut self, count: usize) {
        self.found.truncate(count);
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// All errors as `compile_error!`s; `None` if there are none.
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

/// Reads something again whose errors are already reported.
pub fn silently<T>(read: impl FnOnce(&mut Errors) -> T) -> T {
    let mut reported = Errors::default();
    let found = read(&mut reported);
    let _ = reported.finish();
    found
}

/// All values, if there is no `None` among them. Every value is read, so that no error hides
/// another.
pub fn every<T>(read: impl IntoIterator<Item = Option<T>>) -> Option<Vec<T>> {
    let all: Vec<Option<T>> = read.into_iter().collect();
    all.into_iter().collect()
}
