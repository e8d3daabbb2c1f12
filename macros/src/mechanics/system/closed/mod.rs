//! The motion of a system that is held by more than the joints of its tree, and its constraint
//! loads,
//!
//! ```text
//! M q'' - A^T l = f        A q'' = -b        A: slopes of the constraints, b: their bias
//! ```
//!
//! In the plane the motion is found block by block, without the loads. Systems that are no chain of
//! such blocks, and those in space, are eliminated together, the masses first. Both hold in all
//! states in which the rows of A are independent.

mod assembly;
mod dependent;
mod eliminated;
mod guard;
mod in_plane;
mod inverse;
mod known;
mod numbers;
mod release;
mod semidefinite;
mod solve;
mod unsettled;

pub use assembly::Coordinates;
pub use inverse::solve_drives;
pub use known::moved_in_world;
pub use release::{component, release};
pub use solve::{Closed, close};
pub use unsettled::{Spare, check_kept};
