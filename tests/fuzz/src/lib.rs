//! Fuzzing: how the expander and the runtime respond to arbitrary input. Every execution follows
//! from a seed and its index alone, so that findings can be reproduced.
#![allow(missing_docs)]
#![allow(
    clippy::must_use_candidate,
    clippy::missing_panics_doc,
    clippy::return_self_not_must_use,
    reason = "the package is a command, and nobody's library"
)]

pub mod corpus;
pub mod flat;
pub mod generate;
pub mod mutate;
pub mod run;
pub mod runtime;
pub mod times;
pub mod verdict;
pub mod words;
