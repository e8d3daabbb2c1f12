//! Loops in the plane, in absolute angles. The slopes of a loop are then the arms of its links, and
//! the inertia couples only links that carry each other.
//!
//! ```text
//! q'' = T x - d        T: each joint has the angle of its link, less that of its carrier
//! ```

mod absolute;
mod arms;
mod masses;
mod shortest;
mod slopes;

pub use absolute::Absolute;
pub use arms::Arms;
pub use masses::derive_masses;
pub use shortest::shortest;
pub use slopes::{of_hinge, of_row};
