//! Loops: joints between bodies that others carry already. Their loads are found with the
//! accelerations,
//!
//! ```text
//! M q'' - A^T l = f        A q'' = -b        A: slopes of the constraints, b: their bias
//! ```

mod rows;
mod solve;
mod world;

pub use solve::{Closed, close, moved_in_world};
