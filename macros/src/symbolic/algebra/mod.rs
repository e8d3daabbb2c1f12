//! Computations over nodes, in numbers of any kind: values, changes, substitution.

mod affine;
pub mod chain_rule;
mod evaluate;
mod exact;
mod fold;
mod multiples;
mod operations;
mod slopes;
mod substitute;
mod tape;

pub use exact::Exact;
pub use multiples::Multiples;
pub use operations::Algebra;
pub use slopes::{slope, slopes, takes_first};
pub use tape::Tape;
