//! What the expander says to a stream, and whether that is an answer at all.

use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::time::Duration;

use cpu_time::ThreadTime;
use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::expand;
use crate::flat::{Token, unflatten};

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
    let start = ThreadTime::now();
    EXPANDING.set(true);
    let output = catch_unwind(AssertUnwindSafe(|| expand(input)));
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

/// The least part of the tokens for which `fails` still holds, by leaving out shorter and shorter stretches.
pub fn minimised(tokens: &[Token], fails: impl Fn(&[Token]) -> bool) -> Vec<Token> {
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
