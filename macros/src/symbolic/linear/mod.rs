//! Linear equations with expressions as coefficients.

mod blocks;
mod determinant;
mod eliminate;

pub use eliminate::{Elimination, Equation, Size, Undetermined};
