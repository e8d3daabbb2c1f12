//! Functions that cannot panic: `cargo test --test no_panic`.
//!
//! The crate `no-panic` puts a guard into each of the following functions. On unwinding, the guard
//! calls a symbol that does not exist, so this program links if and only if the optimizer has
//! removed every path on which a function could panic. `docs/trust.md` lists what is left out, and
//! why.

#![allow(clippy::result_large_err, reason = "errors hold a state")]

#[macro_use]
mod guard;

mod by_hand;
mod ensembles;
mod evaluations;
#[path = "../../kinds/mod.rs"]
mod kinds;
mod motions;
#[path = "../../handwritten/mod.rs"]
mod systems;

fn main() {
    let count = evaluations::link() + motions::link() + by_hand::link() + ensembles::link();
    println!("{count} functions");
}
