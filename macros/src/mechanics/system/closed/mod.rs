//! The motion of a system that is held by more than the joints of its tree, and the loads of its
//! constraints,
//!
//! ```text
//! M q'' - A^T l = f        A q'' = -b        A: slopes of the constraints, b: their bias
//! ```
//!
//! In the plane, the motion is solved for block by block, without the loads. Systems that do not
//! split into such blocks, and systems in space, are eliminated as a whole, masses first. Both ways
//! are correct in all states in which the rows of A are independent.

mod dependent;
mod eliminated;
mod groups;
mod guard;
mod in_plane;
mod inverse;
mod rank;
mod release;
mod rows;
mod semidefinite;
mod solve;
mod undetermined;

pub use eliminated::{Following, equations};
pub use inverse::solve_drives;
pub use rank::Coordinates;
pub use release::{component, release};
pub use rows::moved_in_world;
pub use solve::{Closed, close};
pub use undetermined::{Spare, check_closed, check_kept, check_lost};
