//! Endless bad input: the response of the expander and the runtime to arbitrary input.
//!
//! The compiler is mounted here, since a proc-macro crate cannot be linked. Every execution follows
//! from a seed and its index alone, so that findings can be reproduced.
#![allow(missing_docs, dead_code)]
#![allow(
    unfulfilled_lint_expectations,
    reason = "what is public here is private in the compiler"
)]
#![allow(
    clippy::must_use_candidate,
    clippy::missing_panics_doc,
    clippy::return_self_not_must_use,
    reason = "the package is a command, and nobody's library"
)]

#[path = "../../../macros/src/checks.rs"]
mod checks;
#[path = "../../../macros/src/emit/mod.rs"]
mod emit;
#[path = "../../../macros/src/errors/mod.rs"]
pub mod errors;
#[path = "../../../macros/src/expand.rs"]
mod expand;
#[path = "../../../macros/src/families.rs"]
pub mod families;
#[path = "../../../macros/src/fraction.rs"]
pub mod fraction;
#[path = "../../../macros/src/lower/mod.rs"]
pub mod lower;
#[path = "../../../macros/src/mechanics/mod.rs"]
pub mod mechanics;
#[path = "../../../macros/src/model/mod.rs"]
pub mod model;
#[path = "../../../macros/src/outputs/mod.rs"]
pub mod outputs;
#[path = "../../../macros/src/range.rs"]
pub mod range;
#[path = "../../../macros/src/symbolic/mod.rs"]
pub mod symbolic;
#[path = "../../../macros/src/syntax/mod.rs"]
pub mod syntax;

pub mod corpus;
pub mod flat;
pub mod generate;
pub mod mutate;
pub mod run;
pub mod runtime;
pub mod times;
pub mod verdict;
pub mod words;
