//! `linearization`: the first derivatives of the motion, in blocks and as matrices.

mod coordinates;
mod matrices;
mod output;

pub use output::Linearization;
