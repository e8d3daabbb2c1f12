//! Taylor series: the recurrences of their coefficients.

mod convolution;
mod expansion;
mod recurrence;
mod recurrences;

pub use convolution::{LANES, Origin, Sum, Term};
pub use recurrences::{Coordinate, Polynomial, Recurrences};
