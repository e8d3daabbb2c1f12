//! What is kept beside the joints of the tree: joints that close loops, and written constraints. The
//! loads that keep it are found with the accelerations,
//!
//! ```text
//! M q'' - A^T l = f        A q'' = -b        A: slopes of the constraints, b: their bias
//! ```

mod eliminated;
mod followers;
mod in_plane;
mod inverse;
mod joints;
mod row;
mod solve;
mod unsettled;
mod world;
mod written;

pub use followers::{check_followers, replace};
pub use inverse::solve_drives;
pub use joints::Ends;
pub use row::Row;
pub use solve::{Closed, close, moved_in_world};
pub use unsettled::check_kept;
pub use world::Placed;
