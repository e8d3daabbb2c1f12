//! The proof that an expression is zero: residues at a random state, on all branches.

mod branches;
mod degree;
mod identity;
mod powers;
mod samples;

pub use branches::until_decided;
pub use identity::Residues;
pub use samples::{Sample, free};
