//! Linear equations with expressions as coefficients.

mod blocks;
mod determinant;
mod eliminate;
mod sizes;

pub use eliminate::{Elimination, Equation, Undetermined};
pub use sizes::Size;
