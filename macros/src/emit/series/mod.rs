//! The recurrences of Taylor series as code: a loop over the orders, with its sums in registers.

mod batch;
mod choice;
mod expansion;
mod names;

pub use expansion::{Expansion, write_axes};
