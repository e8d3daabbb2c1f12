//! Linear equations with expressions as coefficients.

mod blocks;
mod determinant;
mod eliminate;
mod inverse;
mod larger;
mod orthogonal;
mod sizes;
mod span;
mod system;
mod values;

pub use sizes::Size;
pub use span::Span;
pub use system::{Elimination, Equation, Undetermined};
