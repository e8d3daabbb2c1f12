//! What the expander says about a token stream, and whether that is an acceptable answer.

use std::cell::{Cell, RefCell};
use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::time::Duration;

use cpu_time::ThreadTime;
use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::corpus::is_system;
use crate::flat::{Token, unflatten};
use mounted::expand::{expand, expand_system};

/// An answer, and the time of the processor that it took.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Answer {
    Accepted,
    Rejected,
}

/// What is no answer.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Failure {
    Panicked(String),
    /// The output is no list of items.
    Unparsable(String),
    /// Nothing was said.
    Silent,
    /// An error without words.
    Wordless,
    /// A function computes what it does not read.
    Unread(String),
}

impl Failure {
    /// Whether both are of one kind, whatever they say.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        core::mem::discriminant(self) == core::mem::discriminant(other)
    }
}

/// Expands the tokens, and looks at what comes out.
///
/// # Errors
///
/// What was found wrong with the expander.
pub fn ask(tokens: &[Token]) -> Result<(Answer, Duration), Failure> {
    let description = unflatten(tokens);
    let input = quote!((::newton_euler) #description);
    if is_system(tokens) {
        return answer(|| expand_system(input));
    }
    answer(|| expand(input))
}

/// What an expansion says, and the time it takes.
///
/// # Errors
///
/// Where it panics, or says nothing that counts.
pub fn answer(expansion: impl FnOnce() -> TokenStream) -> Result<(Answer, Duration), Failure> {
    let start = ThreadTime::now();
    EXPANDING.set(true);
    let output = catch_unwind(AssertUnwindSafe(expansion));
    EXPANDING.set(false);
    let elapsed = start.elapsed();
    let output = output.map_err(|_| Failure::Panicked(PANIC.take()))?;
    judge(output).map(|answer| (answer, elapsed))
}

thread_local! {
    static EXPANDING: Cell<bool> = const { Cell::new(false) };
    /// What the expander said last, and where, when it panicked.
    static PANIC: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Keeps what a panic of the expander says, instead of printing it.
pub fn keep_panics() {
    let print = take_hook();
    set_hook(Box::new(move |panic| {
        if EXPANDING.get() {
            PANIC.set(panic.to_string());
        } else {
            print(panic);
        }
    }));
}

fn judge(output: TokenStream) -> Result<Answer, Failure> {
    let file: syn::File =
        syn::parse2(output).map_err(|error| Failure::Unparsable(error.to_string()))?;
    if file.items.is_empty() {
        return Err(Failure::Silent);
    }
    let mut answer = Answer::Accepted;
    for item in &file.items {
        let syn::Item::Macro(item) = item else {
            if let Some(name) = unread(item.to_token_stream()) {
                return Err(Failure::Unread(name));
            }
            continue;
        };
        let is_error = item
            .mac
            .path
            .segments
            .last()
            .is_some_and(|last| last.ident == "compile_error");
        if is_error {
            answer = Answer::Rejected;
            let message = syn::parse2::<syn::LitStr>(item.mac.tokens.clone());
            if !message.is_ok_and(|message| !message.value().trim().is_empty()) {
                return Err(Failure::Wordless);
            }
        }
    }
    Ok(answer)
}

/// A name in an array that is taken apart, as in `let [a, b] = sums;`, and not read again: what is
/// computed and left out.
fn unread(tokens: TokenStream) -> Option<String> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let is = |token: &TokenTree, word: &str| token.to_string() == word;
    for (place, token) in tokens.iter().enumerate() {
        if let TokenTree::Group(group) = token
            && let Some(name) = unread(group.stream())
        {
            return Some(name);
        }
        if !is(token, "let") {
            continue;
        }
        let [TokenTree::Group(pattern), rest @ ..] = &tokens[place + 1..] else {
            continue;
        };
        let mut given = Vec::new();
        names(pattern.stream(), &mut given);
        let mut read = Vec::new();
        names(rest.iter().cloned().collect(), &mut read);
        let read: HashSet<String> = read.into_iter().collect();
        let is_left_out = |name: &String| !name.starts_with('_') && !read.contains(name);
        let found = given.into_iter().find(is_left_out);
        if found.is_some() {
            return found;
        }
    }
    None
}

fn names(tokens: TokenStream, found: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => names(group.stream(), found),
            TokenTree::Ident(name) if name != "_" => {
                found.push(name.to_string());
            }
            _ => {}
        }
    }
}

/// The least part of the tokens for which `fails` still holds, by leaving out shorter and shorter stretches.
pub fn minimized(tokens: &[Token], fails: impl Fn(&[Token]) -> bool) -> Vec<Token> {
    let mut least = tokens.to_vec();
    let mut length = least.len().div_ceil(2);
    while length > 0 {
        let mut place = 0;
        while place < least.len() {
            let end = (place + length).min(least.len());
            let shorter = [&least[..place], &least[end..]].concat();
            if fails(&shorter) {
                least = shorter;
            } else {
                place += length;
            }
        }
        length /= 2;
    }
    least
}
