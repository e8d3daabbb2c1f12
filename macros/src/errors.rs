//! Errors of a description: collected with the place that has to change, reported all at once.

use proc_macro2::{Span, TokenStream};
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
            source: None,
        }
    }

    /// The same, for an item at a place in a file.
    pub fn within(self, source: Source) -> Self {
        Self {
            source: Some(source),
            ..self
        }
    }

    /// An item at the same place in a file, underlined elsewhere.
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
    /// The places in files, in words.
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

    /// Reports an error in place of a value.
    pub fn report<T>(
        &mut self,
        place: impl Into<Extent>,
        message: impl core::fmt::Display,
    ) -> Option<T> {
        self.push(place, message);
        None
    }

    /// Registers a place in a file, which the errors found there name.
    pub fn source(&mut self, words: String) -> Source {
        self.sources.push(words);
        Source(self.sources.len() - 1)
    }

    pub fn count(&self) -> usize {
        self.found.len()
    }

    /// Forgets errors beyond this count: the source will be read again.
    pub fn take_back(&mut self, count: usize) {
        self.found.truncate(count);
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
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

/// Reads a source again, whose errors are already reported.
pub fn silently<T>(read: impl FnOnce(&mut Errors) -> T) -> T {
    let mut reported = Errors::default();
    let found = read(&mut reported);
    let _ = reported.finish();
    found
}

/// All values, if no error was reported. Every one is read, so that no mistake hides another.
pub fn every<T>(read: impl IntoIterator<Item = Option<T>>) -> Option<Vec<T>> {
    let all: Vec<Option<T>> = read.into_iter().collect();
    all.into_iter().collect()
}

/// The one of `known` that `name` was probably meant to be.
pub fn similar<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // a name of one letter is close to all others of one letter
    let tolerated = match name.chars().count() {
        0 | 1 => 0,
        2..=5 => 1,
        length => 1 + length / 5,
    };
    let distances = known
        .into_iter()
        .map(|known| (distance(name, known), known));
    let is_cased = |known: &str| known != name && known.eq_ignore_ascii_case(name);
    distances
        .filter(|(distance, known)| {
            (1..=tolerated).contains(distance) && known.len() > 1 || is_cased(known)
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, known)| known)
}

/// Each row lists words for one kind of joint: here, in files, and in other tools.
const JOINTS: [&[&str]; 10] = [
    &[
        "revolute",
        "hinge",
        "pin",
        "fixed_axis",
        "continuous",
        "rotary",
        "rotational",
    ],
    &["prismatic", "slide", "slider", "sliding", "linear"],
    &[
        "spherical",
        "ball",
        "ball_joint",
        "ball_and_socket",
        "fixed_point",
        "pivot",
    ],
    &["weld", "fixed", "rigid"],
    &[
        "free",
        "floating",
        "free_joint",
        "freejoint",
        "six_dof",
        "spatial",
    ],
    &["universal", "cardan", "hooke"],
    &["screw", "helical"],
    &["pin_in_slot", "slot", "pin_slot"],
    &["planar", "plane"],
    &["cylindrical", "cylinder", "pin_in_slot"],
];

/// The known kind of joint that a word means elsewhere.
fn joint_meant<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    let mut rows = JOINTS.iter().filter(|row| row.contains(&word.as_str()));
    rows.find_map(|row| known.iter().copied().find(|known| row.contains(known)))
}

/// `; did you mean ...?` for kinds of joints, or nothing.
pub fn hint_of_joint(word: &str, known: &[&str]) -> String {
    let meant = joint_meant(word, known).or_else(|| similar(word, known.iter().copied()));
    meant.map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// Functions by their names elsewhere.
const FUNCTIONS: [(&str, &str); 13] = [
    ("log", "ln"),
    ("sgn", "signum"),
    ("sign", "signum"),
    ("fabs", "abs"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("pow", "powi"),
    ("square", "powi"),
    ("inv", "recip"),
    ("norm2", "norm_squared"),
    ("ceiling", "ceil"),
];

/// The function of scalars or vectors that a word means elsewhere.
pub fn function_meant(word: &str) -> Option<&'static str> {
    let mut all = FUNCTIONS.iter();
    all.find_map(|(elsewhere, here)| (*elsewhere == word).then_some(*here))
}

/// `; did you mean ...?`, or nothing.
pub fn hint<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    similar(name, known).map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// The number of insertions, deletions, substitutions and exchanges of neighbors from `a` to `b`.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let same = a[i - 1] == b[j - 1];
            let mut least = rows[i - 1][j - 1] + usize::from(!same);
            least = least.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}
