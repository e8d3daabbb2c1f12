//! Bodies: what one is to an integrator, what it answers, and what is known of it at compile time.

pub mod body;
pub mod columns;
pub mod constrained;
pub mod linearization;
pub mod operations;
pub(crate) mod path;
pub mod structure;
pub(crate) mod switches;
