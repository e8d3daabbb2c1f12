//! The compiler as a library. Its rooms are mounted here, because a proc-macro crate cannot be
//! linked.
#![allow(missing_docs, dead_code, reason = "tests alone use it")]
#![allow(
    clippy::all,
    clippy::pedantic,
    unfulfilled_lint_expectations,
    reason = "clippy reads it in its place"
)]

#[path = "../../../macros/src/checks.rs"]
pub mod checks;
#[path = "../../../macros/src/emit/mod.rs"]
pub mod emit;
#[path = "../../../macros/src/errors/mod.rs"]
pub mod errors;
#[path = "../../../macros/src/expand.rs"]
pub mod expand;
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
#[path = "../../../macros/src/text.rs"]
pub mod text;
#[path = "../../../macros/src/units.rs"]
pub mod units;
