//! Constraints outside the tree: joints that close loops, and written constraints.

mod followers;
mod held;
mod joints;
mod row;
mod world;
mod written;

pub use followers::{check_followers, replace, split};
pub use joints::{Ends, rows as rows_of_joint};
pub use row::ConstraintRow;
pub use world::{Placed, place_links};
pub use written::{push as push_written, rows as rows_of_written};
