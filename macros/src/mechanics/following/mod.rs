//! Loads that depend on unknowns that are solved for: accelerations, and the loads of constraints.

mod added;
mod added_to_link;
mod definite;
mod linear;
mod settled;

pub use added::Added;
pub use linear::{LOAD, REACTION, check_linear, check_parts, unknowns_in};
pub use settled::{as_given, settle, takes_inertia, with_settled};
