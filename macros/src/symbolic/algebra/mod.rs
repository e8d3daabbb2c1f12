//! What is computed of nodes, in numbers of any kind: values, changes, substitution.

mod algebra;
pub mod chain_rule;
mod evaluate;
mod slopes;
mod substitute;
mod tape;

pub use algebra::Algebra;
pub use slopes::{slope, slopes, takes_first};
pub use tape::Tape;
