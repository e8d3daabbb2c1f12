//! The rows that depend on others in closed states. Found numerically, so it only selects a form of
//! the equations.

mod assembly;
mod branches;
mod numbers;
mod part;

pub use assembly::{Coordinates, Rank};
pub use branches::rank;
