//! Lowering: from the written description to its meaning.

mod definitions;
mod description;
mod expressions;
mod inertia;
mod loads;
mod system;

pub use definitions::{FLOW, INVERSE, LINEARIZATION, Offer};
pub use description::{lower_description, outline};
pub use expressions::{is_drive, is_unknown};
pub use system::{lower_system, outline_system, targets};
