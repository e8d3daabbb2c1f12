//! Linear equations with expressions as coefficients.

mod eliminate;
mod solve;

pub use eliminate::{Elimination, Row, Size};
pub use solve::{Equation, Solution};
