//! Constraints outside the tree: joints that close loops, and written constraints.

mod followers;
mod held;
mod joints;
mod loops;
mod placed;
mod row;
mod written;

pub use followers::{check_followers, replace, split};
pub use joints::rows as rows_of_joint;
pub use loops::{Ends, Loop};
pub use placed::{Placed, place_links};
pub use row::ConstraintRow;
pub use written::{push as push_written, rows as rows_of_written};
