//! `linearization`: the first derivatives of the motion, in blocks and as matrices.

mod coordinates;
mod emitted;
mod matrices;
mod names;
mod output;
mod sensitivity;

pub use output::Linearization;
pub use sensitivity::Sensitivity;
