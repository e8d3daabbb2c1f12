//! NaN and infinite numbers: what they do, and that every call terminates.
//!
//! Evaluations propagate them. Integrations report them, with the last good state. The rules are in
//! `docs/trust.md`.

#![allow(clippy::float_cmp, reason = "the same to the bit")]
#![allow(clippy::result_large_err, reason = "errors hold a state")]

use std::sync::mpsc::channel;
use std::time::Duration;

mod by_hand;
mod constructors;
mod ensembles;
mod evaluations;
#[path = "../kinds/mod.rs"]
mod kinds;
mod motions;
mod observations;
mod singular;

/// What some work gives, if it ends within a time that is a hundred times what it needs.
fn bounded<T: Send + 'static>(what: &str, work: impl FnOnce() -> T + Send + 'static) -> T {
    let (sender, receiver) = channel();
    std::thread::spawn(move || sender.send(work()));
    let result = receiver.recv_timeout(Duration::from_secs(20));
    result.unwrap_or_else(|error| panic!("{what}: {error}"))
}
