//! Loops in the plane, in absolute angles. In these, the slopes of a loop are the arms of its
//! links, and inertia couples only links of which one carries the other.
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
